import type { World } from '../../../physics-core/inside.js';
import type { Binding } from '../nodes/binding.js';
import {
  placing,
  repeatsBodyPose,
  standsInScene,
  type Placing,
} from '../document/collidable-pose.js';
import { isShape } from '../words/dom.js';
import { GeometryReader, noteWaiting } from '../document/geometry-reader.js';
import { axisAngleOf, decompose, identity, withLinear } from '../geometry/matrix.js';
import { nodesIn, type Plan } from './plan.js';
import { standInMatrix } from '../document/shortcuts.js';
import { collidablesIn, ownerOf, tellCircles } from '../document/structure.js';
import { transformsAbove } from '../scopes/transforms.js';

export function planShape(binding: Binding, world: World): Plan {
  const reader = new GeometryReader(binding);
  const { standIn } = binding;
  const own = [...binding.element.children].some(isShape);
  const named = binding.named('shape');
  const placed = placing(binding);
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
        binding.scope!.all.around(element) ?? binding.scope!,
        withLinear(identity(), placed.linear),
      );
  noteWaiting(binding, reader);
  return { world, relations: { shape: reader.found, ...poseOf(binding, placed) } };
}

/** Its place where its own fields do not say it. */
function poseOf(binding: Binding, { pose }: Placing): Record<string, unknown> {
  followAbove(binding);
  if (!pose) return {};
  return {
    translation: pose.position.map((value) => value * binding.units.length),
    rotation: axisAngleOf(pose.quaternion),
  };
}

/**
 * What is above it gives a collidable its scale; one that no body owns moves with the edits of that, too, though not with
 * the simulation.
 */
function followAbove(binding: Binding): void {
  const { readers, drivers } = binding.scene!;
  if (!standsInScene(binding)) return;
  const transforms = transformsAbove(binding.element, binding.scope!);
  for (const transform of transforms) readers.add(transform, binding);
  if (ownerOf(binding)) return;
  const body = transforms.map((transform) => drivers.of(transform)).find((each) => each);
  if (!body) return;
  binding.fault((faults) => faults.unmoved(binding, body.label));
}

export function planOffset(binding: Binding, world: World): Plan {
  tellCircles(binding);
  const child = collidablesIn(binding, 'collidable')[0];
  const collidable = child ? (nodesIn(world, [child], binding)[0] ?? null) : null;
  const relations: Record<string, unknown> = { collidable };
  Object.assign(relations, poseOf(binding, placing(binding)));
  if (repeatsBodyPose(binding))
    Object.assign(relations, { translation: [0, 0, 0], rotation: [0, 0, 1, 0] });
  return { world, relations };
}
