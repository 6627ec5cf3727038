import { codecs } from '../../../physics-core/inside.js';
import { placed } from '../document/geometry-reader.js';
import { standInMatrix } from '../document/shortcuts.js';
import { isIdentity, matrixOf, multiply, quaternionOf } from '../geometry/matrix.js';
import type { Binding } from '../nodes/binding.js';
import type { StandIn } from '../nodes/stand-in.js';
import { transformsAbove } from '../scopes/transforms.js';

/**
 * What it says in the frame that it stands in, or for, as it is in the world; it is told of edits of that. `box`: as large as it
 * looks, metres.
 */
export function placedIn(
  water: Binding,
  standIn: StandIn,
  box: number[] | undefined,
): Record<string, unknown> {
  const { shapes, scope } = standIn;
  for (const transform of transformsAbove(shapes, scope))
    water.scene!.readers.add(transform, water);
  const asked = water.authoredFields();
  const value = (name: string): number[] => {
    const field = water.type.fields[name]!;
    return (codecs[field.type].accept(asked[name] ?? field.default) ?? field.default) as number[];
  };
  const { length } = scope.units;
  const [x, y, z] = value('position');
  const [ax, ay, az, angle] = value('orientation');
  const frame = standInMatrix(standIn);
  const there = placed(
    { type: 'Box' },
    multiply(
      frame,
      matrixOf({
        position: [x / length, y / length, z / length],
        quaternion: quaternionOf([ax, ay, az, angle]),
      }),
    ),
    length,
  );
  const { translation = [0, 0, 0], rotation = [0, 0, 1, 0], linear } = there;
  const relations: Record<string, unknown> = {};
  if (!isIdentity(frame))
    Object.assign(relations, { position: translation, orientation: rotation });
  if (box || linear) {
    const size = water.wrote('size') ? undefined : box;
    relations.size = (size ?? value('size')).map(
      (each, axis) => each * scaleAlong(axis, linear as number[]),
    );
  }
  return relations;
}

/** How much longer things are along an axis: `linear` is row-major, 3 × 3. */
const scaleAlong = (axis: number, linear: number[] | undefined): number =>
  linear ? Math.hypot(linear[axis], linear[3 + axis], linear[6 + axis]) : 1;
