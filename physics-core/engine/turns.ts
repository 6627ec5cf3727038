import { atan2 } from '../base/exact/index.js';

/** Beyond this, radians, Bullet turns a body by less than its spin says. */
export const BULLETS_TURN = Math.PI / 4;

/** What turned farther than this in a step is looked after in the next: it may have sped up by then. */
export const FAR_TURN = BULLETS_TURN / 2;

/** By so much it turns what should turn by `angle` radians: its quaternion has the sine and the cosine of different angles. */
export const turnByBullet = (angle: number): number =>
  angle > BULLETS_TURN ? 2 * atan2((Math.SQRT2 - 1) * angle, BULLETS_TURN) : angle;
