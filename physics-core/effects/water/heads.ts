import { grown } from '../../base/grown.js';
import type { Cover, Volume } from './volume.js';
import { addDip, DIPS } from './dip.js';

const point = new Float64Array(3);

/** How deep points of a surface are in a volume of water, and which shares of it count. */
export class Heads {
  /** How far each is below its surface, and below its bottom, metres. */
  surface = new Float64Array(0);
  floor = new Float64Array(0);
  /** The same below that of what is there instead. */
  cover = new Float64Array(0);
  /** Which share of a place is between its sides, and between those of what is there instead. */
  share = 1;
  covered = 0;
  /** Of all points: how deep the lowest is, and the highest. */
  deepest = 0;
  highest = 0;
  #isBounded = false;
  /** What that is. */
  covering: Cover | undefined;
  /** Of a sheet, from its upper side to its lower one, metres. */
  thick = 0;

  /** False: none of them is in it, nor nearer than `reach` metres. */
  measure(volume: Volume, places: Float64Array, count: number, reach: number): boolean {
    if (this.surface.length < count) this.#grow(count);
    this.deepest = -Infinity;
    this.highest = Infinity;
    let lowest = -Infinity;
    let highest = Infinity;
    for (let i = 0; i < count; i++) {
      for (let k = 0; k < 3; k++) point[k] = places[3 * i + k]!;
      this.surface[i] = volume.waterAbove(point);
      this.floor[i] = volume.bottomAbove(point);
      this.deepest = Math.max(this.deepest, this.surface[i]!);
      this.highest = Math.min(this.highest, this.surface[i]!);
      lowest = Math.max(lowest, this.floor[i]!);
      highest = Math.min(highest, this.floor[i]!);
    }
    this.#isBounded = lowest > -reach;
    return this.deepest > -reach && highest < reach;
  }

  #grow(count: number): void {
    for (const each of ['surface', 'floor', 'cover'] as const)
      this[each] = grown(this[each], count);
  }

  /** There is something else, where it is. */
  coverWith(cover: Cover, places: Float64Array, i: number): void {
    const { volume: other } = cover;
    this.covering = cover;
    for (let k = 0; k < 3; k++) point[k] = places[3 * i + k]!;
    this.cover[i] = Math.min(this.surface[i]!, other.above(point));
  }

  /** The same as another has it. */
  coverAs({ covering }: Heads, places: Float64Array, i: number): void {
    if (covering) this.coverWith(covering, places, i);
  }

  /** What a sheet of so many m³ displaces more for each metre that it sinks, m², where it goes through the surface. */
  rises(i: number, j: number, m: number, volume: number): number {
    const { surface } = this;
    const low = Math.max(surface[i]!, surface[j]!, surface[m]!);
    const high = Math.min(surface[i]!, surface[j]!, surface[m]!);
    const thick = this.thick;
    return low > -thick / 2 && high < thick / 2 ? volume / (thick + low - high || 1) : 0;
  }

  /** Which share of a place counts that goes so far up and down around a point, metres. */
  shareAt(i: number, high: number): number {
    let share = this.share * within(this.surface[i]!, high);
    if (this.covered > 0) share -= this.covered * within(this.cover[i]!, high);
    if (this.#isBounded) share += (this.covered - this.share) * within(this.floor[i]!, high);
    return share;
  }

  /** Of a triangle, moved down by so much: what of it is between surface and bottom, and not where something else is. */
  dip(i: number, j: number, m: number, lower: number, out: Float64Array): void {
    const { surface, floor, cover, share, covered } = this;
    out.fill(0, 0, DIPS);
    addDip(surface[i]! + lower, surface[j]! + lower, surface[m]! + lower, share, out);
    if (covered > 0) addDip(cover[i]! + lower, cover[j]! + lower, cover[m]! + lower, -covered, out);
    if (this.#isBounded)
      addDip(floor[i]! + lower, floor[j]! + lower, floor[m]! + lower, covered - share, out);
  }
}

const within = (head: number, high: number): number =>
  Math.min(1, Math.max(0, 0.5 + head / high / 2));
