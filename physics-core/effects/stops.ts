import { perStep, softnessAtStep } from '../accuracy/levels.js';
import type { JointNode } from '../nodes/joint.js';
import type { World } from '../world/world.js';
import { Effect } from './effect.js';

/** Below this rate (rad/s, m/s) a stop holds instead of bouncing. */
const LEAST_BOUNCE = 0.01;

/** Distance from a stop (rad, m) at which it counts as left. */
const LEFT = 1e-3;

/** A row of a joint that may not go past `low` and `high`; one of them may be infinite. */
export interface Stop {
  /** As the 6-DoF numbers them, body1 against body2. */
  row: number;
  low: number;
  high: number;
  /** Share of the rate that comes back. */
  bounce: number;
  /** Share of an overshoot repaired per 1/60 s. */
  correction: number;
  /** X3D's constantForceMix: how far it gives way. */
  softness: number;
  /** What `jointlimit` says of it: its field counts the other way round, and which axis it is, where there are more. */
  mirrored?: boolean;
  axis?: 1 | 2;
  /** Where it stands: at its upper end (1), at its lower one, or between; undefined before its first step. */
  at: -1 | 0 | 1 | undefined;
  /** Rate given by the last step to repair an overshoot past the lower and the upper end. */
  lent: [number, number];
}

/** Joints that have stops. */
interface Stopped extends JointNode {
  readonly stops: readonly Stop[];
}

/**
 * Bullet's own limit rows rebound from a stop by themselves and hardly bounce when asked to. Where a joint would pass a
 * stop in the coming step, this gives it the rate that it shall have after it, through all rows of the joint at once
 * and with the forces of the step counted in, so that it stops where it should (measured). Bullet's limits stay on
 * behind hard stops as a net.
 */
export class Stops extends Effect {
  readonly name = 'stops';
  readonly #world: World;
  readonly #reached: [Stopped, Stop][] = [];

  constructor(world: World) {
    super();
    this.#world = world;
  }

  override beforeStep(dt: number): void {
    const { rows } = this.#world.registry;
    for (const node of this.causes) {
      const joint = node as Stopped;
      if (!rows.read(joint, dt)) continue;
      for (const stop of joint.stops) {
        const value = rows.values[stop.row]!;
        const side = this.#hold(stop, value, 1, dt) || this.#hold(stop, value, -1, dt);
        this.#note(joint, stop, value, side);
      }
    }
  }

  /** Keeps a row from going past its upper (`side` 1) or lower end; the side where it was in the way, else 0. */
  #hold(stop: Stop, value: number, side: 1 | -1, dt: number): -1 | 0 | 1 {
    const { rows } = this.#world.registry;
    rows.look(stop.row);
    const beyond = side * (value - (side > 0 ? stop.high : stop.low));
    const closing = side * rows.rate;
    const lent = Math.min(stop.lent[side > 0 ? 1 : 0]!, Math.max(0, -closing));
    stop.lent[side > 0 ? 1 : 0] = 0;
    // What was lent to repair an overshoot is no motion of its own: it is taken back.
    const coming = side * rows.coming + lent;
    const inTheWay = beyond + coming * dt >= 0;
    if (!inTheWay && lent === 0) return 0;
    const share = beyond > 0 ? perStep(stop.correction, dt) : 1;
    const wanted =
      stop.bounce > 0 && closing > LEAST_BOUNCE ? -stop.bounce * closing : (-share * beyond) / dt;
    if (inTheWay && beyond > 0 && coming > wanted && closing <= LEAST_BOUNCE)
      stop.lent[side > 0 ? 1 : 0] = -wanted;
    this.#push(stop, side, (inTheWay ? Math.min(coming, wanted) : coming) - side * rows.coming, dt);
    return inTheWay ? side : 0;
  }

  /** Changes the rate of the row looked at. */
  #push(stop: Stop, side: 1 | -1, change: number, dt: number): void {
    if (change === 0) return;
    const { rows } = this.#world.registry;
    const give = change < 0 ? softnessAtStep(stop.softness, stop.correction, dt) / dt : 0;
    rows.push(stop.row, (side * change) / (rows.ease + give));
  }

  #note(joint: Stopped, stop: Stop, value: number, side: -1 | 0 | 1): void {
    // Who starts at a stop does not reach it.
    if (side !== 0 && side !== (stop.at ?? side)) this.#reached.push([joint, stop]);
    if (side !== 0) stop.at = side;
    else if (value < stop.high - LEFT && value > stop.low + LEFT) stop.at = 0;
  }

  override afterStep(): void {
    for (const [joint, stop] of this.#reached)
      if (joint.heard('jointlimit')) this.#tell(joint, stop);
    this.#reached.length = 0;
  }

  #tell(joint: Stopped, { at, mirrored, low, high, axis }: Stop): void {
    const upper = at === 1;
    const value = (mirrored ? -1 : 1) * (upper ? high : low);
    joint.emit('jointlimit', {
      limit: upper === !mirrored ? 'max' : 'min',
      value,
      ...(axis && { axis }),
      time: this.#world.time,
    });
  }
}

/** What a node asks of a stop, from its fields. */
export type StopFields = Omit<Stop, 'at' | 'lent'>;

/** The stop with its new fields, where it stood before. */
export const restopped = (before: Stop | undefined, fields: StopFields): Stop => ({
  ...fields,
  at: before?.at,
  lent: before?.lent ?? [0, 0],
});
