import { GeometryReader } from '../document/geometry-reader.js';
import type { Binding } from '../nodes/binding.js';
import type { StandIn } from '../nodes/stand-in.js';
import { isShape } from '../words/dom.js';

/** X3D's default, metres. */
const BOX = [2, 2, 2];

/**
 * What is seen of water: the Shapes in the Transform that it stands in, or for, or the one that it names. Those of a body that
 * moves that Transform are the body's: a tub with water in it.
 */
export function shapesOf(water: Binding, { transform, shapes }: StandIn): Element[] {
  const { readers, drivers } = water.scene!;
  readers.add(shapes, water);
  if (isShape(shapes)) return [shapes];
  return transform && drivers.of(transform) ? [] : [...shapes.children].filter(isShape);
}

/** The size of the first Box of some Shapes, metres. */
export function boxIn(
  water: Binding,
  shapes: readonly Element[],
  { scope }: StandIn,
): number[] | undefined {
  const reader = new GeometryReader(water);
  for (const shape of shapes) reader.collect(shape, scope);
  const box = reader.found.find(({ type }) => type === 'Box');
  return box && ((box.size as number[] | undefined) ?? BOX);
}
