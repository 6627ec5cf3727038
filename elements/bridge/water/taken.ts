import { unsolid } from '../document/geometry-reader.js';
import type { Binding } from '../nodes/binding.js';

/** The Shapes of each water. */
const taken = new WeakMap<Binding, readonly Element[]>();

/** These Shapes are what is seen of water, so no body's; bodies that read them hear of it. */
export function takeShapes(water: Binding, shapes: readonly Element[]): void {
  const before = taken.get(water) ?? [];
  taken.set(water, shapes);
  for (const shape of before) {
    if (shapes.includes(shape)) continue;
    unsolid.delete(shape);
    tell(shape, water);
  }
  for (const shape of shapes) {
    if (unsolid.has(shape)) continue;
    unsolid.add(shape);
    tell(shape, water);
  }
}

function tell(shape: Element, water: Binding): void {
  for (const reader of [...water.scene!.readers.of(shape)]) if (reader !== water) reader.dirty();
}
