import { standInOf } from '../document/shortcuts.js';
import { collectionOf } from '../document/structure.js';
import { identity, multiply, type Affine } from '../geometry/matrix.js';
import type { Binding } from '../nodes/binding.js';
import { composed, localMatrix, transformsAbove } from '../scopes/transforms.js';
import { isTransform } from '../words/dom.js';

/**
 * From the frame in which a rope, a cloth, a soft body, or what ties one, says its places to the world, in the lengths that x3dom draws. In a
 * collection that is the world's own. `reader` is told of edits of the Transforms.
 */
export function frameOf(binding: Binding, reader = binding): Affine {
  const { drivers, readers } = reader.scene!;
  let matrix = identity();
  for (const [transform, angle] of transformsOf(binding)) {
    readers.add(transform, reader);
    // What a body moves is where its author put it: there it is laid, wherever that has gone since.
    const own = drivers.of(transform) ? composed(transform, angle) : localMatrix(transform);
    matrix = multiply(own, matrix);
  }
  return matrix;
}

/** Nearest first, with the radians of their file's angle. */
function transformsOf(binding: Binding): (readonly [Element, number])[] {
  const standIn = standInOf(binding);
  if (!standIn && collectionOf(binding)) return [];
  const { shapes, scope } = standIn ?? { shapes: binding.element, scope: binding.scope! };
  const all = [...(isTransform(shapes) ? [shapes] : []), ...transformsAbove(shapes, scope)];
  return all.map((each) => [each, scope.units.angle] as const);
}

/** Points flat, or one, metres: where they are in the world. */
export function inWorld(m: Affine, points: readonly number[], length: number): number[] {
  const out: number[] = [];
  for (let i = 0; i + 2 < points.length; i += 3)
    for (let row = 0; row < 12; row += 4)
      out.push(
        m[row] * points[i]! +
          m[row + 1] * points[i + 1]! +
          m[row + 2] * points[i + 2]! +
          m[row + 3] * length,
      );
  return out;
}
