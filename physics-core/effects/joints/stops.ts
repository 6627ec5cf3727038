import type { JointNode } from '../../nodes/joint.js';
import type { PhysicsNode } from '../../nodes/node.js';
import type { World } from '../../world/world.js';
import { Effect } from '../effect.js';

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
}

/** What a node asks of a stop, from its fields. */
type StopFields = Omit<Stop, 'at'>;

interface Stopped extends JointNode {
  stops: readonly Stop[];
}

/** Joints that have stops, which the joint solve keeps; here it is told when one is reached. */
export class Stops extends Effect {
  readonly name = 'stops';
  readonly #world: World;
  readonly #reached: [JointNode, Stop][] = [];

  constructor(world: World) {
    super();
    this.#world = world;
  }

  /** The one stop of a joint, by its fields; none where it is free, locked, or its ends are not there. */
  set(joint: Stopped, fields: StopFields, reason: string): void {
    if (!joint.attached || fields.low >= fields.high) {
      joint.stops = [];
      this.drop(joint);
      return;
    }
    joint.stops = [{ ...fields, at: joint.stops[0]?.at }];
    this.need(joint, reason);
  }

  override need(node: PhysicsNode, reason: string): void {
    super.need(node, reason);
    this.#world.registry.joints.update(node as JointNode);
  }

  /** `side`: where a stop was in the way in this step; 0: nowhere. */
  note(joint: JointNode, stop: Stop, value: number, side: -1 | 0 | 1): void {
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

  #tell(joint: JointNode, { at, mirrored, low, high, axis }: Stop): void {
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
