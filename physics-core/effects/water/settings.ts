import type { Pose } from '../../base/math.js';
import type { Vec3 } from '../../fields/types.js';

/** What its author says of a volume of water. */
export interface WaterSettings {
  readonly enabled: boolean;
  /** Of its middle; the surface is its upper side. */
  readonly pose: Pose;
  /** Metres. */
  readonly size: Vec3;
  /** kg/m³. */
  readonly density: number;
  /** Of the cross-section that goes against the water. */
  readonly drag: number;
  /** Of faces that stand aslant to the water. */
  readonly lift: number;
  /** 1/s. */
  readonly damping: number;
  /** Share of the displaced water's mass that goes along. */
  readonly addedMass: number;
  /** Of the water itself, world frame, m/s. */
  readonly flow: Vec3;
  /** Undefined: its surface stands still. */
  readonly waves: WaveSettings | undefined;
}

/** What its author says of a surface that moves. */
export interface WaveSettings {
  /** Cells along its width and its length. */
  readonly subdivision: readonly [number, number];
  /** Waves go out at the edges. */
  readonly open: boolean;
  /** 1/s. */
  readonly damping: number;
}
