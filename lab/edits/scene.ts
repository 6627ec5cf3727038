// A scene of any size in which the same things are edited: what one edit costs must not hang on who else is there.
import { createWorld } from '../../physics-core/create.js';
import { type PhysicsNode, type World } from '../../physics-core/inside.js';
import type { BodyNode } from '../../physics-core/nodes/body/body.js';

/** Boxes on the ground that jump one after another. */
export const LYING = 5;

const BOX = { type: 'Box', size: [0.5, 0.5, 0.5] };

export interface Scene {
  world: World;
  body: BodyNode;
  /** More on the ground. */
  lying: BodyNode[];
  /** Is fixed; a box lies on it. */
  stone: BodyNode;
  shape: PhysicsNode;
  joint: PhysicsNode;
}

/** Boxes on the ground, every fourth with another on a joint above it; and what is edited, which lies on the ground, too. */
export async function scene(bodies: number, rest: 'auto' | 'never'): Promise<Scene> {
  const world = await createWorld({ rest });
  world.add('RigidBody', {
    fixed: true,
    position: [0, -0.5, 0],
    geometry: [{ type: 'Box', size: [500, 1, 500] }],
  });
  for (let i = 0; i < bodies; i++) pile(world, i);
  const shape = world.add('CollidableShape', { shape: [BOX] });
  const body = world.add('RigidBody', { position: [-3, 0.25, 0], geometry: [shape] }) as BodyNode;
  const arm = world.add('RigidBody', { position: [-5, 5, 0], geometry: [BOX] });
  const joint = world.add('BallJoint', { body1: arm, anchorPoint: [-5, 6, 0] });
  const lying = Array.from(
    { length: LYING },
    (_, i) => world.add('RigidBody', { position: [-8 - i, 0.25, 0], geometry: [BOX] }) as BodyNode,
  );
  const stone = world.add('RigidBody', {
    fixed: true,
    position: [-15, 0.25, 0],
    geometry: [BOX],
  }) as BodyNode;
  world.add('RigidBody', { position: [-15, 0.75, 0], geometry: [BOX] });
  world.advance(0.5);
  return { world, body, lying, stone, shape, joint };
}

function pile(world: World, i: number): void {
  const [x, z] = [(i % 25) * 3, Math.floor(i / 25) * 3];
  const hangs = i % 4 === 3;
  const body1 = world.add('RigidBody', { position: [x, hangs ? 5 : 0.25, z], geometry: [BOX] });
  if (hangs) world.add('BallJoint', { body1, anchorPoint: [x + 0.5, 6, z] });
}

/** Each does another edit every time. */
export const EDITS: Record<string, (scene: Scene, i: number) => void> = {
  'mass, in place': ({ body }, i) => body.set('mass', 1 + (i % 7)),
  'position, a jump': ({ body }, i) => body.set('position', [-3, 0.25 + (i % 7) / 100, 0]),
  'a size, another shape': ({ shape }, i) =>
    shape.set('shape', [{ type: 'Box', size: [0.5, 0.5 + (i % 7) / 100, 0.5] }]),
  'an anchor, the joint anew': ({ joint }, i) =>
    joint.set('anchorPoint', [-5, 6 + (i % 7) / 100, 0]),
  'a body added and removed': ({ world }) => {
    const body = world.add('RigidBody', { position: [-20, 0.25, 0], geometry: [BOX] });
    world.step(0);
    body.remove();
  },
  'position of a fixed body, a jump': ({ stone }, i) =>
    stone.teleport([-15, 0.25 - (i % 7) / 100, 0]),
  'a fixed body added and removed': ({ world }) => {
    const body = world.add('RigidBody', { fixed: true, position: [-20, 0.25, 0], geometry: [BOX] });
    world.step(0);
    body.remove();
  },
  'position, a jump of who was put to sleep': ({ lying }, i) => {
    lying[0]!.sleep();
    lying[0]!.set('position', [-8, 0.25 + (i % 7) / 100, 0]);
  },
};
