import type { Body } from '../../dynamics/body.js';
import type { Vec3 } from '../../fields/types.js';
import type { Grabbed } from '../drag/soft.js';
import type { Cause } from '../effect/effect.js';

/** What the author of a rope says. */
export interface RopeSettings {
  readonly enabled: boolean;
  /** Along it, as it is laid, metres, author's world: x, y, z of each point. */
  readonly points: readonly number[];
  /** kg. */
  readonly mass: number;
  /** Metres. */
  readonly radius: number;
  /** By how much of its length each newton stretches it; 0: it does not stretch. */
  readonly softness: number;
  /** N m². */
  readonly bending: number;
  /** Share of its speed that it loses, 1/s. */
  readonly damping: number;
  readonly friction: number;
  /** It touches itself. */
  readonly selfCollision: boolean;
  /** Points that stay where they are. */
  readonly fixed: readonly number[];
  /** m/s². */
  readonly gravity: Vec3;
  /** FALSE: it never rests. */
  readonly rests: boolean;
}

/** A node that is a rope. */
export interface RopeSource extends Grabbed {
  readonly settings: RopeSettings;
  /** Steps of this length follow so much of its bending, N m². */
  bends(most: number): void;
  /** Its numbers were lost: it stands where it was. */
  stopped(): void;
  /** It came into water, or out of it. */
  emit(event: string, detail: unknown): void;
  /** After each step of one that moved. */
  stepped(): void;
}

/** A node that ties a point of a rope to a body, or to a place in the world. */
export interface Tie extends Cause {
  readonly id: number;
  readonly rope: RopeSource | undefined;
  readonly index: number;
  /** Undefined: the world. */
  readonly body: Body | undefined;
  /** In the frame of the body, or of the world. */
  readonly position: Vec3;
  /** Its body, where it names one, stands in the world. */
  readonly holds: boolean;
}
