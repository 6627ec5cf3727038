import { codecs } from '../../../physics-core/inside.js';
import { ownBinding, type Binding } from '../nodes/binding.js';
import { isType } from '../words/dom.js';
import {
  decompose,
  identity,
  isIdentity,
  matrixOf,
  multiply,
  quaternionOf,
  withLinear,
  type Affine,
  type Pose,
} from '../geometry/matrix.js';
import { ownerOf } from './structure.js';
import { drawnPlace } from '../scopes/standing.js';
import { matrixAbove } from '../scopes/transforms.js';

// Where collidables stand, going by the document.

/** A collidable that stands in the scene has the Transforms above it; one inside a body has none. */
export const above = (collidable: Binding): Affine =>
  isPart(collidable) ? identity() : matrixAbove(collidable.element, collidable.scope!);

/** Wherever it is drawn, if it is, it is what another node has. */
function isPart({ element, scope }: Binding): boolean {
  const { parentElement } = scope ? drawnPlace(element, scope).element : element;
  return !parentElement || isType(parentElement, ...UNDRAWN);
}

/** Itself, or the offsets around it. */
export function standsInScene(collidable: Binding): boolean {
  const around = offsetAround(collidable);
  return around ? standsInScene(around) : !isPart(collidable);
}

/** What a collidable is a part of without standing in the scene there. */
const UNDRAWN = ['RigidBody', 'CollidableOffset', 'CollisionCollection', 'CollisionSpace'];

/** Its own translation and rotation, in file lengths and radians. */
export function localPose(collidable: Binding): Affine {
  const [x, y, z] = valueOf(collidable, 'translation');
  const [ax, ay, az, angle] = valueOf(collidable, 'rotation');
  const quaternion = quaternionOf([ax, ay, az, angle * collidable.units.angle]);
  return matrixOf({ position: [x, y, z], quaternion });
}

/** Where the document puts a collidable otherwise than its own fields say, and the scale that its shape has there. */
export interface Placing {
  pose?: Pose | undefined;
  linear: number[] | undefined;
}

/** One without a body is an obstacle that stands where it is drawn; a scaled offset moves what is in it. */
export function placing(collidable: Binding): Placing {
  const offset = offsetAround(collidable);
  const frame = offset ? insideOf(offset) : above(collidable);
  if (isIdentity(frame)) return { linear: undefined };
  if (!offset && ownerOf(collidable)) return { linear: decompose(frame).linear };
  const pose = decompose(multiply(frame, localPose(collidable)));
  return { pose, linear: pose.linear };
}

/** The scale inside an offset, seen from where the offset itself is. */
function insideOf(offset: Binding): Affine {
  const around = offsetAround(offset);
  const frame = around ? insideOf(around) : above(offset);
  // The arm in a body is as it is written.
  const arm = !around && ownerOf(offset) ? identity() : localPose(offset);
  return withLinear(identity(), decompose(multiply(frame, arm)).linear);
}

function offsetAround({ element }: Binding): Binding | undefined {
  const parent = element.parentElement;
  return parent && isType(parent, 'CollidableOffset') ? ownBinding(parent) : undefined;
}

export const collidableMatrix = (collidable: Binding): Affine =>
  multiply(above(collidable), localPose(collidable));

/**
 * X_ITE and Titania write into an offset that stands in the scene the pose of its body, where the standard has the
 * arm from the body: then the arm is in the child alone (KineticPendulum.x3d).
 */
export function repeatsBodyPose(offset: Binding): boolean {
  const body = ownerOf(offset);
  if (
    !body ||
    offset.element.parentElement === body.element ||
    !offset.wrote('translation', 'rotation')
  )
    return false;
  const same = (own: string, its: string): boolean => {
    const a = valueOf(offset, own);
    return valueOf(body, its).every(
      (value, i) => Math.abs(value - a[i]) <= 1e-5 * Math.max(1, Math.abs(value)),
    );
  };
  return same('translation', 'position') && same('rotation', 'orientation');
}

/** What the author wrote, in file units, or the default. */
function valueOf(binding: Binding, name: string): number[] {
  const field = binding.type.fields[name];
  const written = binding.authored(name);
  return ((written !== undefined && codecs[field.type].accept(written)) ||
    field.default) as number[];
}
