import { particles } from '../effects/particles/effects.js';
import type { CloudPicture } from '../effects/particles/seen.js';
import type { World } from '../world/world.js';

/** Bytes that are kept: ten seconds of 4,000 particles. Where it were more, what lies long back is kept less often. */
const MOST = 64 * 2 ** 20;

interface Picture {
  readonly step: number;
  readonly clouds: ReadonlyMap<number, CloudPicture>;
  readonly bytes: number;
}

/** Where particles were. */
export class CloudPictures {
  #all: Picture[] = [];
  #bytes = 0;

  /** The end of a step. */
  add(step: number, { registry }: World): void {
    const effect = registry.find(particles);
    if (!effect) return;
    const clouds = new Map(effect.pictures);
    const bytes = [...clouds.values()].reduce((sum, cloud) => sum + bytesOf(cloud), 0);
    this.#all.push({ step, clouds, bytes });
    this.#bytes += bytes;
    const last = this.#all.length - 1;
    if (this.#bytes > MOST) this.#keep((_, i) => (last - i) % 2 === 0);
  }

  #keep(which: (picture: Picture, i: number) => boolean): void {
    this.#all = this.#all.filter(which);
    this.#bytes = this.#all.reduce((sum, { bytes }) => sum + bytes, 0);
  }

  /** Particles of a world are shown as they were: in the last picture up to a step; before the first there were none. */
  show(step: number, { registry }: World): void {
    const picture = this.#all.findLast((each) => each.step <= step);
    registry.find(particles)?.lookBack(picture?.clouds ?? new Map());
  }

  /** Those of steps after one have not been. */
  cut(after: number): void {
    this.#keep(({ step }) => step <= after);
  }

  /** Those of steps before are kept no more, but for the last one if that step has none of its own. */
  drop(before: number): void {
    const first = this.#all.findLastIndex(({ step }) => step <= before);
    this.#keep((_, i) => i >= first);
  }
}

const bytesOf = ({ motion, ages }: CloudPicture): number => motion.byteLength + ages.byteLength;
