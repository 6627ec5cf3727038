import type { World } from '../../../physics-core/inside.js';
import { addBody, addFloor, addJoint, box, sphere, world } from '../helpers.js';

/** Boxes and balls that fall onto a floor and a jointed pair, and are listened to. */
export async function busy(): Promise<World> {
  const w = await world({ rest: 'auto' });
  addFloor(w);
  w.add('CollisionCollection', {
    collidables: '*',
    appliedParameters: ['BOUNCE'],
    bounce: 0.4,
  });
  for (let i = 0; i < 12; i++)
    addBody(w, {
      position: [0.3 * (i % 3), 1 + i, 0.2 * (i % 2)],
      geometry: [i % 2 ? sphere(0.4) : box(0.7)],
    }).on('collisionstart', () => {});
  const last = addBody(w, { position: [4, 2, 0] });
  addJoint(w, 'BallJoint', { body1: last, anchorPoint: [3, 2, 0] });
  w.advance(1);
  return w;
}

/** A ball on a hinge, let go level. */
export async function pendulum(fields: Record<string, unknown> = {}): Promise<World> {
  const w = await world(fields);
  const ball = addBody(w, { position: [1, 0, 0], geometry: [sphere(0.1)] });
  addJoint(w, 'SingleAxisHingeJoint', { body1: ball, axis: [0, 0, 1] });
  w.advance(0.3);
  return w;
}
