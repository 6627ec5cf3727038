import type { Joint, Stop } from '../../dynamics/joint.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { Effect } from '../effect/effect.js';

/** Distance from a stop (rad, m) at which it counts as left. */
const LEFT = 1e-3;

/** Joints that have stops, which the joint solve keeps; here it is told when one is reached. */
export class Stops extends Effect {
  readonly #simulation: Simulation;
  readonly #reached: [Joint, Stop][] = [];

  constructor(simulation: Simulation) {
    super();
    this.#simulation = simulation;
  }

  /** `side`: where a stop was in the way in this step; 0: nowhere. */
  note(joint: Joint, stop: Stop, value: number, side: -1 | 0 | 1): void {
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

  #tell(joint: Joint, { at, mirrored, low, high, axis }: Stop): void {
    const upper = at === 1;
    const value = (mirrored ? -1 : 1) * (upper ? high : low);
    joint.emit('jointlimit', {
      limit: upper === !mirrored ? 'max' : 'min',
      value,
      ...(axis && { axis }),
      time: this.#simulation.time,
    });
  }
}
