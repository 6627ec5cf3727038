import type { PhysicsNode, World } from '../../physics-core/inside.js';
import type { BodyNode as Body } from '../../physics-core/nodes/body/body.js';

/** Bodies of each scene. */
export const BODIES = 200;

/** So far apart that they never meet, metres; rows of so many. */
const APART = 4;
const ROW = 20;

export const box = (...size: number[]) => ({ type: 'Box', size });
const sphere = { type: 'Sphere', radius: 0.5 };

/** What is done before each step. */
type Each = () => void;

/** The one scene of the chart, and what is otherwise in it. */
export interface Scene {
  /** Fields of each body. */
  body?: Record<string, unknown>;
  /** A joint of each body with the world. */
  joint?: readonly [type: string, fields: Record<string, unknown>];
  /** They stand on one. */
  floor?: boolean;
  /** Fields of the RigidBodyCollection. */
  world?: Record<string, unknown>;
  /** What comes to it before it starts. */
  also?(world: World, bodies: readonly Body[], floor: Body | undefined): void;
  /** What its author does once it has started; returns what is done before each step. */
  each?(world: World, bodies: readonly Body[], floor: Body | undefined): Each | Promise<Each>;
}

const placeOf = (i: number): number[] => [APART * (i % ROW), 0.5, APART * Math.floor(i / ROW)];

/** Puts it into a world; returns what its author does before each step, once that has started. */
export function build(world: World, scene: Scene): () => Each | Promise<Each> {
  const { body: fields, joint, floor: hasFloor, also, each } = scene;
  const floor = hasFloor ? addFloor(world) : undefined;
  const bodies = Array.from({ length: BODIES }, (_, i) => {
    const position = placeOf(i);
    const body = world.add('RigidBody', { geometry: [sphere], ...fields, position }) as Body;
    if (joint) addJoint(world, joint, body, position);
    return body;
  });
  also?.(world, bodies, floor);
  return () => each?.(world, bodies, floor) ?? (() => {});
}

/** Under all of them. */
const addFloor = (world: World): Body =>
  world.add('RigidBody', {
    fixed: true,
    position: [(APART * ROW) / 2, -0.5, (APART * BODIES) / ROW / 2],
    geometry: [box(200, 1, 200)],
  }) as Body;

const addJoint = (
  world: World,
  [type, fields]: NonNullable<Scene['joint']>,
  body1: PhysicsNode,
  [x, y, z]: number[],
): PhysicsNode => world.add(type, { body1, anchorPoint: [x! + 1, y! + 1, z], ...fields });
