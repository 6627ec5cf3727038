import type { Ammo } from './ammo.js';
import type { Engine } from './engine.js';
import { SHAPE, SHAPE_TYPE } from './offsets.js';

type Shape = Ammo['btCollisionShape']['prototype'];
export type ShapeKind = keyof typeof SHAPE_TYPE;

const KINDS = new Map<number, ShapeKind>(
  Object.entries(SHAPE_TYPE).map(([kind, number]) => [number, kind as ShapeKind]),
);

/** What a shape is; undefined for what is not made here. */
export const kindOf = ({ ammo }: Engine, shape: Shape): ShapeKind | undefined =>
  KINDS.get(ammo.HEAP32[(ammo.getPointer(shape) + SHAPE.type) >> 2]!);
