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
import { transformsAbove } from '../geometry/transforms.js';
import type { PageWorld } from './worlds.js';

export function planShape(binding: Binding, world: PageWorld): Plan {
  const reader = new GeometryReader(binding);
  const { standIn } = binding;
  const own = [...binding.element.children].some(isShape);
  const named = binding.named('shape');
  if (standIn && !own && !named)
    reader.collect(
      standIn.shapes,
      standIn.scope,
      withLinear(identity(), decompose(standInMatrix(standIn)).linear),
    );
  else
    for (const element of named ?? [binding.element])
      reader.collect(
        element,
        binding.scope!.scene.scopeOf(element) ?? binding.scope!,
        withLinear(identity(), decompose(above(binding)).linear),
      );
  noteWaiting(binding, reader);
  return { world, relations: { shape: reader.found, ...freePose(binding) } };
}

/** A collidable that no body owns is an obstacle that stands where it is drawn, and moves with what is above it. */
function freePose(binding: Binding): Record<string, unknown> {
  if (ownerOf(binding)) return {};
  const { readers } = binding.scope!.scene;
  for (const transform of transformsAbove(binding.element, binding.scope!))
    readers.add(transform, binding);
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
  Object.assign(relations, freePose(binding));
  if (repeatsBodyPose(binding))
    Object.assign(relations, { translation: [0, 0, 0], rotation: [0, 0, 1, 0] });
  return { world, relations };
}
