// What a page is told of particles whose steps are taken on another thread.
import { PARTICLE } from './cloud.js';
import type { ParticleSystem } from './particle-system.js';
import type { Seen } from './seen.js';

/** Systems by the numbers of their nodes. */
type Systems = Iterable<[id: number, system: ParticleSystem]>;

/** Of a system: the number of its node, how many live, its time, whether all at once were born, and whether it creates. */
const HEAD = 5;
/** Of a particle: those of a cloud, and when it was born. */
const EACH = PARTICLE + 1;

const sizeOf = ({ cloud, first }: Seen): number => HEAD + EACH * (cloud.count - first);

/** Tells what has changed since it was told last. */
export class Told {
  /** What each had changed when it was told. */
  readonly #changes = new WeakMap<ParticleSystem, number>();

  /** Into `room` where that is enough; where not, into another. */
  write(systems: Systems, room: Float64Array<ArrayBuffer>): Float64Array<ArrayBuffer> {
    const due = [...systems].filter(([, system]) => this.#changes.get(system) !== system.changes);
    const size = due.reduce((sum, [, { seen }]) => sum + sizeOf(seen), 1);
    const out = room.length >= size ? room : new Float64Array(Math.ceil(1.5 * size));
    out[0] = due.length;
    let at = 1;
    for (const [id, system] of due) {
      this.#changes.set(system, system.changes);
      at = writeSystem(id, system, out, at);
    }
    return out;
  }
}

function writeSystem(id: number, system: ParticleSystem, out: Float64Array, at: number): number {
  const { seen, progress } = system;
  const { cloud, first, time } = seen;
  const count = cloud.count - first;
  out.set([id, count, time, Number(progress.burst), Number(progress.creates)], at);
  const motionAt = at + HEAD;
  out.set(cloud.motion.subarray(first * PARTICLE, cloud.count * PARTICLE), motionAt);
  out.set(cloud.born.subarray(first, cloud.count), motionAt + count * PARTICLE);
  return at + sizeOf(seen);
}

/** Shows what was told. */
export function hear(systems: ReadonlyMap<number, ParticleSystem>, told: Float64Array): void {
  for (let n = told[0]!, at = 1; n > 0; n--) {
    const count = told[at + 1]!;
    const bornAt = at + HEAD + count * PARTICLE;
    const end = bornAt + count;
    // It was removed here meanwhile.
    const system = systems.get(told[at]!);
    if (system) {
      system.cloud.show(told.subarray(at + HEAD, bornAt), told.subarray(bornAt, end));
      system.progress = {
        time: told[at + 2]!,
        burst: told[at + 3] === 1,
        creates: told[at + 4] === 1,
      };
    }
    at = end;
  }
}
