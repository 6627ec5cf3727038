import type { Volume } from '../volume.js';
import type { Matter, WetSurface } from './matter.js';
import { SoakedSurface } from './soaked-surface.js';
import { WetMatter } from './wet-matter.js';

/** A cloth or a soft body that is in water, or near it, as its parts of a step go. */
export class Swimmer {
  readonly of: Matter & WetSurface;
  readonly #surface = new SoakedSurface();
  wet: WetMatter | undefined;
  volumes: readonly Volume[] = [];

  constructor(of: Matter & WetSurface) {
    this.of = of;
  }

  /** A part of a step begins, and nothing acts on it yet. */
  begin(): void {
    this.#surface.braking.begin(this.of.masses);
  }

  /** Everything else that pushes it in `time` seconds has; places are those at the start. */
  soak(time: number): void {
    const { of, volumes } = this;
    const surface = this.#surface;
    if (!surface.soak(of, volumes, time)) return;
    const { source } = surface.deepest!;
    this.wet ??= new WetMatter(of.id, source);
    this.wet.lie(surface, surface.weighs);
    this.wet.wetted = true;
  }

  /** The part is over. */
  dry(): void {
    this.#surface.braking.dry(this.of.masses);
  }
}
