import { unsolid } from '../document/geometry-reader.js';
import type { Binding } from '../nodes/binding.js';

/** The Shapes of each water and each rope. */
const taken = new WeakMap<Binding, readonly Element[]>();

/** These Shapes are what is seen of water or of a rope, so no body's; bodies that read them hear of it. */
export function takeShapes(user: Binding, shapes: readonly Element[]): void {
  const before = taken.get(user) ?? [];
  taken.set(user, shapes);
  for (const shape of before) {
    if (shapes.includes(shape)) continue;
    unsolid.delete(shape);
    tell(shape, user);
  }
  for (const shape of shapes) {
    if (unsolid.has(shape)) continue;
    unsolid.add(shape);
    tell(shape, user);
  }
}

function tell(shape: Element, user: Binding): void {
  for (const reader of [...user.scene!.readers.of(shape)]) if (reader !== user) reader.dirty();
}
