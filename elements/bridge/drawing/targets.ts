import type { Binding } from '../nodes/binding.js';
import { above, localPose, repeatsBodyPose } from '../document/collidable-pose.js';
import { decompose, identity, multiply, type Affine } from '../geometry/matrix.js';
import type { Target } from './drawing.js';
import { standInMatrix } from '../document/shortcuts.js';
import { collidablesIn } from '../document/structure.js';

/** What is drawn of a collidable of `body`: its own node, and the Transform that it names. */
export function drawn(collidable: Binding, body: Binding, arm?: Affine): Target[] {
  const { scope, element, standIn } = collidable;
  if (!scope) return [];
  const offset = collidable.is('CollidableOffset');
  const placed =
    offset && !repeatsBodyPose(collidable)
      ? multiply(arm ?? identity(), localPose(collidable))
      : arm;
  const targets: Target[] = [];
  if (offset) {
    for (const child of collidablesIn(collidable, 'collidable')) {
      // A child inside the offset's own element is drawn with it.
      if (child.element.parentElement !== element)
        targets.push(...drawn(child, body, childArm(child, placed)));
    }
  }
  targets.push({ element, scope, arm: placed, linear: decompose(above(collidable)).linear });
  if (standIn?.transform) {
    const { linear } = decompose(standInMatrix(standIn));
    targets.push({ element: standIn.transform, scope: standIn.scope, arm: placed, linear });
  }
  return targets;
}

const childArm = (child: Binding, arm: Affine | undefined): Affine =>
  child.is('CollidableShape') ? multiply(arm ?? identity(), localPose(child)) : (arm ?? identity());
