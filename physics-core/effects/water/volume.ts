import type { Vec3 } from '../../fields/types.js';
import { add, AXES, rotate, scale, subtract } from '../../base/math.js';
import type { Cause } from '../effect/effect.js';
import type { BodyFrame } from './body-frame.js';
import type { MovingSurface } from './moving-surface.js';
import type { WaterSettings } from './settings.js';
import type { Skin } from './skin.js';

/** Three numbers. */
type Point = ArrayLike<number>;

const dot = (a: Vec3, b: Point): number => a[0] * b[0]! + a[1] * b[1]! + a[2] * b[2]!;

/** A node that has water. */
export interface WaterSource extends Cause {
  readonly id: number;
  readonly settings: WaterSettings;
  /** What its water weighs by, m/s². */
  readonly gravity: Vec3;
}

/** Where a line meets a surface. */
export interface SurfaceMet {
  node: WaterSource;
  /** World frame, metres. */
  position: Vec3;
  /** Towards where the line came from. */
  normal: Vec3;
  /** Share of the way. */
  fraction: number;
}

/** From where to where, metres. */
type Range = readonly [low: number, high: number];

/** Bounds along the first and the third axis of a volume, from its middle. */
type Sides = Readonly<Record<0 | 2, Range>>;

/** Water that is there instead of another one, between such sides of that. */
export interface Cover {
  readonly volume: Volume;
  readonly sides: Sides;
}

/** Where a box of water is, and what is said of it. */
export class Volume {
  readonly source: WaterSource;
  readonly settings: WaterSettings;
  /** Its axes, world frame: its surface looks along the second. */
  readonly axes: readonly [Vec3, Vec3, Vec3];
  readonly #half: Vec3;
  /** Of its middle along its axes. */
  readonly #middle: Vec3;
  readonly #sides: Sides;
  /** What is there instead where they overlap. */
  covers: readonly Cover[] = [];
  /** Its surface, where that moves. */
  waves: MovingSurface | undefined;

  constructor(source: WaterSource) {
    const { settings } = source;
    const { pose, size } = settings;
    const axes = AXES.map((axis) => rotate(pose.q, axis)) as [Vec3, Vec3, Vec3];
    this.source = source;
    this.settings = settings;
    this.axes = axes;
    this.#half = size.map((each) => each / 2) as Vec3;
    this.#middle = axes.map((axis) => dot(axis, pose.p)) as Vec3;
    const sides = (axis: 0 | 2): Range => [-this.#half[axis], this.#half[axis]];
    this.#sides = { 0: sides(0), 2: sides(2) };
  }

  get gravity(): Vec3 {
    return this.source.gravity;
  }

  get up(): Vec3 {
    return this.axes[1];
  }

  /** How far a point is from the middle along an axis. */
  along(axis: 0 | 1 | 2, point: Point): number {
    return dot(this.axes[axis], point) - this.#middle[axis];
  }

  /** How far its surface is above a point. */
  above(point: Point): number {
    return this.#half[1] - this.along(1, point);
  }

  /** The same of what goes along with its surface where that moves. */
  waterAbove(point: Point): number {
    const { waves } = this;
    const still = this.above(point);
    return waves ? still + waves.heightAt(this.along(0, point), this.along(2, point)) : still;
  }

  /** How far its bottom is above a point. */
  bottomAbove(point: Point): number {
    return -this.#half[1] - this.along(1, point);
  }

  /** Whether a point is between its sides, or other ones. */
  surrounds(point: Point, sides: Sides = this.#sides): boolean {
    const across = this.along(0, point);
    const along = this.along(2, point);
    return (
      across >= sides[0][0] && across <= sides[0][1] && along >= sides[2][0] && along <= sides[2][1]
    );
  }

  /** Whether what reaches so far around a point may be in it. */
  reaches(point: Point, reach: number): boolean {
    return (
      this.above(point) + (this.waves ? this.waves.crest : 0) > -reach &&
      this.bottomAbove(point) < reach &&
      Math.abs(this.along(0, point)) < this.#half[0] + reach &&
      Math.abs(this.along(2, point)) < this.#half[2] + reach
    );
  }

  /** Where a line first goes through its surface. */
  meets(from: Vec3, to: Vec3): SurfaceMet | undefined {
    const start = this.above(from);
    const end = this.above(to);
    if (start > 0 === end > 0) return undefined;
    const fraction = start / (start - end);
    const position = add(from, scale(subtract(to, from), fraction));
    if (!this.surrounds(position)) return undefined;
    return { node: this.source, position, normal: scale(this.up, start > 0 ? -1 : 1), fraction };
  }

  /** Of another volume, as far as it is between the sides of this one; undefined: they are beside each other. */
  coverBy(other: Volume): Cover | undefined {
    const sides = { 0: this.#shared(0, other), 2: this.#shared(2, other) };
    const overlap = [sides[0], sides[2]].every(([low, high]) => high > low);
    return overlap ? { volume: other, sides } : undefined;
  }

  /** What both have of an axis of this one: of a volume that is turned otherwise, as far as it reaches. */
  #shared(axis: 0 | 2, other: Volume): Range {
    const along = this.along(axis, other.settings.pose.p);
    const own = this.axes[axis];
    const half = other.#half;
    const reach = other.axes.reduce((sum, each, k) => sum + Math.abs(dot(own, each)) * half[k]!, 0);
    const [low, high] = this.#sides[axis];
    return [Math.max(low, along - reach), Math.min(high, along + reach)];
  }

  /**
   * Which share of a body's width is between its sides, or other ones. A wall of water is none of nature's: what goes through
   * it gets more and less of it evenly.
   */
  share(frame: BodyFrame, skin: Skin, reach: number, sides: Sides = this.#sides): number {
    const across = this.#shareAlong(0, frame, skin, reach, sides[0]);
    return across > 0 ? across * this.#shareAlong(2, frame, skin, reach, sides[2]) : 0;
  }

  /** The same of so many points. */
  shareOf(points: Float64Array, count: number, sides: Sides = this.#sides): number {
    const across = this.#shareOf(0, points, count, sides[0]);
    return across > 0 ? across * this.#shareOf(2, points, count, sides[2]) : 0;
  }

  #shareOf(axis: 0 | 2, points: Float64Array, count: number, [from, to]: Range): number {
    let low = Infinity;
    let high = -Infinity;
    for (let i = 0; i < count; i++) {
      for (let k = 0; k < 3; k++) way[k] = points[3 * i + k]!;
      const at = this.along(axis, way);
      low = Math.min(low, at);
      high = Math.max(high, at);
    }
    const within = Math.min(high, to) - Math.max(low, from);
    return high > low ? Math.max(0, within / (high - low)) : 0;
  }

  #shareAlong(axis: 0 | 2, frame: BodyFrame, skin: Skin, reach: number, [from, to]: Range): number {
    const along = this.along(axis, frame.centre);
    if (along - reach >= from && along + reach <= to) return 1;
    if (along + reach <= from || along - reach >= to) return 0;
    frame.inward(this.axes[axis], 0, way, 0);
    const low = along - skin.farthest(way, -1);
    const high = along + skin.farthest(way, 1);
    const within = Math.min(high, to) - Math.max(low, from);
    return high > low ? Math.max(0, within / (high - low)) : 0;
  }
}

const way = new Float64Array(3);

/** Where they overlap there is what is denser; of two that are alike, the first. */
export function volumesOf(sources: readonly WaterSource[]): Volume[] {
  const there = sources.filter(({ settings }) => settings.enabled);
  const volumes = there.map((source) => new Volume(source));
  volumes.forEach((volume, i) => {
    const { density } = volume.settings;
    const denser = volumes.filter(({ settings }, j) =>
      settings.density === density ? j < i : settings.density > density,
    );
    volume.covers = denser.flatMap((other) => volume.coverBy(other) ?? []);
  });
  return volumes;
}
