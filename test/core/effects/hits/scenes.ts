import { addBody, addFloor, height, velocity, world, type Body } from '../../helpers.js';

export const GRAVITY = 9.81;

/** A ball of 0.5 m that falls onto a floor from `drop` metres above it. */
export async function dropped(accuracy: string, bounce: number, drop = 2) {
  const w = await world({ accuracy, gravity: [0, -GRAVITY, 0] });
  addFloor(w);
  w.add('CollisionCollection', { collidables: '*', bounce, minBounceSpeed: 0 });
  const ball = addBody(w, { position: [0, 0.5 + drop, 0] });
  return { w, ball };
}

/** Height of the flight it is in, from its energy. */
export const flight = (ball: Body): number =>
  height(ball) - 0.5 + velocity(ball)[1] ** 2 / (2 * GRAVITY);
