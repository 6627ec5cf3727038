import type { FieldCodec } from '../fields/values.js';
import type { Value } from '../fields/types.js';

/**
 * What keeps bad numbers away from Bullet, each as one function, so that the mutation tests can let one through at a
 * time and see that a test notices.
 */
/** Of a field that takes numbers: as its table has it. */
interface Range {
  range?: readonly [number, number];
  open?: boolean;
}

export const guards = {
  /** The value as its field type, or undefined where it is malformed. */
  wellFormed: (codec: FieldCodec, value: unknown): Value | undefined => codec.accept(value),

  inRange(field: Range, value: Value): boolean {
    if (!field.range) return true;
    const [low, high] = field.range;
    const numbers = Array.isArray(value) ? (value as number[]) : [value as number];
    return numbers.every((n) => n >= low && n <= high && !(field.open && n === low));
  },

  /** Numbers that come in by fields, geometry and methods: fields/bounds.ts has the bounds. */
  bounded: (numbers: readonly number[], most: number): boolean =>
    numbers.every((value) => Math.abs(value) <= most),

  /** A mass of which Bullet can take the inverse; 0 is fixed. */
  massive: (mass: number, least: number): boolean => mass === 0 || mass >= least,

  /** `sum` of the numbers of a state: one NaN or infinity among them shows in it. */
  finiteState: (sum: number): boolean => Number.isFinite(sum),

  /** Wall time of one frame that is simulated, seconds: a slow frame must not breed slower ones. */
  frameTime: (seconds: number, longest: number): number => Math.min(seconds, longest),

  /** Principal moments of an authored inertia: with a negative one a body gains energy at every touch. */
  positive: (moments: readonly number[]): boolean => moments.every((moment) => moment > 0),

  /** Moments of a needle, lifted so that it can't spin up without bound. */
  leastMoment: (moment: number, least: number): number => Math.max(moment, least),

  /** Softness of a joint in Bullet's terms; from 1 on Bullet lets the joint go. */
  jointSoftness: (cfm: number, most: number): number => Math.min(most, cfm),

  /** A joint that an edit tore apart: what closes its error is no motion and gives nobody any. */
  torn: (error: number, least: number): boolean => error > least,

  /** Masses that contacts hold: the heavier one lies on the lighter. Others are told of. */
  alike: (heavy: number, light: number, most: number): boolean => heavy <= most * light,

  /** Bytes of the wasm heap: where it is full nothing is made any more. */
  roomy: (bytes: number, most: number): boolean => bytes <= most,

  /** What an impulse of the last step is worth once a body of its contact has another mass: it would throw a light one. */
  impulseOfOtherMass: (_impulse: number): number => 0,

  /** Bodies that are so near to 0 0 0 that single precision is fine enough, metres. */
  near: (distance: number, most: number): boolean => distance <= most,

  /** Extents thinner than this have no volume to collide with. */
  thickness: (extent: number, thinnest: number): number => Math.max(extent, thinnest),
};
