import type { Binding } from './binding.js';
import { above, localPose, repeatsBodyPose } from '../geometry/collidable-pose.js';
import { isShape } from '../document/dom.js';
import { GeometryReader, noteWaiting } from '../geometry/reader.js';
import {
  axisAngleOf,
  decompose,
  identity,
  isIdentity,
  multiply,
  withLinear,
} from '../geometry/matrix.js';
import { nodesIn, type Plan } from './plan.js';
import { standInMatrix } from '../document/shortcuts.js';
import { collidablesIn, ownerOf } from '../document/structure.js';
import type { PageWorld } from './worlds.js';

export function planShape(binding: Binding, world: PageWorld): Plan {
  const reader = new GeometryReader(binding);
  const { standIn } = binding;
  const own = [...binding.element.children].some(isShape);
  if (standIn && !own)
    reader.collect(
      standIn.shapes,
      standIn.scope,
      withLinear(identity(), decompose(standInMatrix(standIn)).linear),
    );
  else
    reader.collect(
      binding.element,
      binding.scope!,
      withLinear(identity(), decompose(above(binding)).linear),
    );
  noteWaiting(binding, reader);
  const relations: Record<string, unknown> = { shape: reader.found };
  const free = !ownerOf(binding);
  if (free) Object.assign(relations, freePose(binding));
  return { world, relations };
}

/** A collidable that no body owns is an obstacle that stands where it is drawn. */
function freePose(binding: Binding): Record<string, unknown> {
  const upon = above(binding);
  if (isIdentity(upon)) return {};
  const { position, quaternion } = decompose(multiply(upon, localPose(binding)));
  return {
    translation: position.map((value) => value * binding.units.length),
    rotation: axisAngleOf(quaternion),
  };
}

export function planOffset(binding: Binding, world: PageWorld): Plan {
  const child = collidablesIn(binding, 'collidable')[0];
  const collidable = child ? (nodesIn(world, [child], binding)[0] ?? null) : null;
  const relations: Record<string, unknown> = { collidable };
  if (repeatsBodyPose(binding))
    Object.assign(relations, { translation: [0, 0, 0], rotation: [0, 0, 1, 0] });
  return { world, relations };
}
