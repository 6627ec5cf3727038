import { SheetSolid } from '../../effects/particles/collide/sheet.js';
import type { BoundedModelNode } from './model-node.js';

/** Those that were made last, by the first of the models that they are of: it takes a while to make them. */
const made = new WeakMap<BoundedModelNode, { geometries: unknown[]; walls: SheetSolid }>();

const areSame = (some: readonly unknown[], others: readonly unknown[]): boolean =>
  some.length === others.length && some.every((each, i) => each === others[i]);

/** All that the models hold particles in, or out of; undefined: nothing. */
export function wallsOf(models: readonly BoundedModelNode[]): SheetSolid | undefined {
  const [first] = models;
  if (!first) return undefined;
  const geometries = models.map((model) => model.asked('geometry'));
  const known = made.get(first);
  if (known && areSame(known.geometries, geometries)) return known.walls;
  const points: number[] = [];
  const index: number[] = [];
  for (const { mesh } of models) {
    const before = points.length / 3;
    for (const number of mesh.points) points.push(number);
    for (const corner of mesh.index) index.push(before + corner);
  }
  if (index.length === 0) return undefined;
  const walls = new SheetSolid(points, index);
  made.set(first, { geometries, walls });
  return walls;
}
