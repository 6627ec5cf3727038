// Words for the scenes of the cases.
import type { World } from '../../physics-core/inside.js';
import type { BodyNode } from '../../physics-core/nodes/body/body.js';
import type { JointNode } from '../../physics-core/nodes/joints/joint.js';
import type { SingleAxisHingeJointNode } from '../../physics-core/nodes/joints/single-axis-hinge-joint-node.js';
import type { Play } from './case.js';

export type Vec3 = [number, number, number];
export type Body = BodyNode;
export type Joint = JointNode;
export type Hinge = SingleAxisHingeJointNode;
export type Fields = Record<string, unknown>;

export const box = (...size: number[]) => ({
  type: 'Box',
  size: size.length === 1 ? [size[0], size[0], size[0]] : size,
});
export const sphere = (radius: number) => ({ type: 'Sphere', radius });

export const addBody = (to: World, fields: Fields = {}): Body =>
  to.add('RigidBody', { geometry: [sphere(0.5)], ...fields }) as Body;

/** A fixed slab whose top lies at `top`. */
export const addFloor = (to: World, top = 0, fields: Fields = {}): Body =>
  addBody(to, {
    fixed: true,
    position: [0, top - 0.5, 0],
    geometry: [box(60, 1, 60)],
    ...fields,
  });

export const addJoint = (to: World, type: string, fields: Fields): Joint =>
  to.add(type, fields) as Joint;

export const addHinge = (to: World, fields: Fields): Hinge =>
  to.add('SingleAxisHingeJoint', fields) as Hinge;

/** Only joints count. */
export const nothingCollides = (w: World): void =>
  void w.add('CollisionCollection', { collidables: '*', enabled: false });

export const position = (body: Body): Vec3 => body.get('position') as Vec3;
export const velocity = (body: Body): Vec3 => body.get('linearVelocity') as Vec3;
export const spin = (body: Body): Vec3 => body.get('angularVelocity') as Vec3;
export const speed = (body: Body): number => Math.hypot(...velocity(body));
export const height = (body: Body): number => position(body)[1];

export const distance = (a: readonly number[], b: readonly number[]): number =>
  Math.hypot(...a.map((value, i) => value - b[i]!));

export const most = (numbers: readonly number[]): number => Math.max(...numbers);
export const widest = (joints: readonly Joint[]): number => most(joints.map(({ gap }) => gap));
export const fastest = (bodies: readonly Body[]): number => most(bodies.map(speed));

/** The greatest that is ever seen after a step. */
export function greatest(look: () => number, more: Omit<Play, 'after' | 'measured'> = {}): Play {
  let found = 0;
  return {
    ...more,
    after: () => {
      const now = look();
      found = Number.isNaN(now) ? NaN : Math.max(found, now);
    },
    measured: () => found,
  };
}

/** As it is in the end. */
export const atTheEnd = (look: () => number, more: Omit<Play, 'measured'> = {}): Play => ({
  ...more,
  measured: look,
});

/** How far the one that moved most is from where it was put. */
export function moved(bodies: readonly Body[]): () => number {
  const before = bodies.map(position);
  return () => most(bodies.map((body, i) => distance(position(body), before[i]!)));
}

/** The same sequence in every run. */
export function random(seed = 1): () => number {
  let state = seed;
  return () => (state = (state * 16807) % 2147483647) / 2147483647;
}
