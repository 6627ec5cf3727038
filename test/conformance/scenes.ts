import type { NodeData } from './fact.js';

type Fields = Record<string, unknown>;
type Vec3 = [number, number, number];

/** A world. Its DEF is `world` unless the fields give another. */
export const collection = (fields: Fields = {}): NodeData => ({
  type: 'RigidBodyCollection',
  DEF: 'world',
  ...fields,
});

export const WEIGHTLESS = { gravity: [0, 0, 0] };

export const use = (name: string): NodeData => ({ USE: name });

export const box = (x: number, y = x, z = x): NodeData => ({ type: 'Box', size: [x, y, z] });
export const sphere = (radius: number): NodeData => ({ type: 'Sphere', radius });

/** A CollidableShape around a geometry. */
export const collidable = (geometry: NodeData, fields: Fields = {}): NodeData => ({
  type: 'CollidableShape',
  shape: { type: 'Shape', geometry },
  ...fields,
});

/** A collidable placed away from the origin of its body. */
export const offset = (translation: Vec3, child: NodeData, fields: Fields = {}): NodeData => ({
  type: 'CollidableOffset',
  translation,
  collidable: child,
  ...fields,
});

/** A body; a ball of 1 kg and 0.5 m unless the fields say otherwise. */
export const body = (DEF: string, fields: Fields = {}): NodeData => ({
  type: 'RigidBody',
  DEF,
  geometry: [collidable(sphere(0.5))],
  ...fields,
});

/** A fixed slab of 60 × 1 × 60 m whose top lies at `top`. */
export const slab = (top = 0, fields: Fields = {}): NodeData =>
  body('slab', {
    fixed: true,
    position: [0, top - 0.5, 0],
    geometry: [collidable(box(60, 1, 60), { DEF: 'slabShape' })],
    ...fields,
  });

/** Moments of inertia about the main axes as X3D's matrix. */
export const inertia = (x: number, y = x, z = x): number[] => [x, 0, 0, 0, y, 0, 0, 0, z];

/** A joint, DEF `joint`, between bodies named by DEF; a body that is not named is left out. */
export const joint = (
  type: string,
  bodies: { body1?: string; body2?: string },
  fields: Fields = {},
): NodeData => ({
  type,
  DEF: 'joint',
  ...(bodies.body1 ? { body1: use(bodies.body1) } : {}),
  ...(bodies.body2 ? { body2: use(bodies.body2) } : {}),
  ...fields,
});

/** Earth's pull as X3D has it, m/s². */
export const G = 9.8;
