import type { PhysicsNode } from '../../../physics-core/inside.js';
import { axisAngleOf, decompose, invert, matrixOf, multiply } from '../geometry/matrix.js';
import { inMetres, type StartPose } from './plan.js';
import type { Target } from '../drawing/drawing.js';
import { drivenMatrix, matrixAbove } from '../scopes/transforms.js';

const CARRIED = ['position', 'orientation', 'linearVelocity', 'angularVelocity'];

/** A body moved in the tree keeps its pose and velocity. */
export const stateOf = (node: PhysicsNode): Record<string, unknown> | undefined =>
  node.type.name === 'RigidBody'
    ? Object.fromEntries(CARRIED.map((name) => [name, node.get(name)]))
    : undefined;

export function restoreState(node: PhysicsNode, state: Record<string, unknown>): void {
  for (const [name, value] of Object.entries(state)) node.event(name, value);
}

interface BodyLike extends PhysicsNode {
  motion: { start: StartPose | undefined };
}

/**
 * A fixed body is carried along, and carries what stands on it; another one jumps. An edit like any other: joints that
 * were edited in the same task are made anew at the new pose, whichever came first.
 */
export function moveTo(node: PhysicsNode, { p, q }: StartPose): void {
  // That is also where a reset takes it.
  (node as BodyLike).motion.start = { p, q };
  node.event('position', p);
  node.event('orientation', axisAngleOf(q));
}

/** Where a body is, going by what it moves. */
export function drawnPose({ element, scope, arm }: Target): StartPose {
  const drawn = decompose(multiply(matrixAbove(element, scope), drivenMatrix(element, scope)));
  return inMetres(
    arm ? decompose(multiply(matrixOf(drawn), invert(arm))) : drawn,
    scope.units.length,
  );
}
