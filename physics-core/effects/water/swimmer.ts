import type { Volume } from './volume.js';
import type { Braking } from './braking.js';
import type { Matter, Points } from './matter.js';
import { WetMatter, type Lying } from './wet-matter.js';

/** How something of that kind is soaked. */
export interface Soaked<Kind> extends Lying {
  readonly braking: Braking;
  /** kg, of its own. */
  readonly weighs: number;
  /** Pushes it for so many seconds. False: it is in no water. */
  soak(of: Kind, volumes: readonly Volume[], time: number): boolean;
}

/** What gives way and is in water, or near it, as its step goes, or each part of that. */
export class Swimmer<Kind = never> {
  readonly of: Matter & Kind;
  readonly #points: Points;
  readonly #soaked: Soaked<Kind>;
  wet: WetMatter | undefined;
  volumes: readonly Volume[] = [];

  constructor(of: Matter & Kind, points: Points, soaked: Soaked<Kind>) {
    this.of = of;
    this.#points = points;
    this.#soaked = soaked;
  }

  /** Whether it is still that of its points. */
  isOf(of: Matter, points: Points): boolean {
    return this.of === of && this.#points === points;
  }

  /** Nothing acts on it yet. */
  begin(): void {
    this.#soaked.braking.begin(this.#points);
  }

  /** Everything else that pushes it in `time` seconds has; places are those at the start. */
  soak(time: number): void {
    const { of, volumes } = this;
    const soaked = this.#soaked;
    if (!soaked.soak(of, volumes, time)) return;
    const { source } = soaked.deepest!;
    this.wet ??= new WetMatter(of.id, source);
    this.wet.lie(soaked, soaked.weighs);
    this.wet.wetted = true;
  }

  /** What holds it meanwhile has: it is as heavy as it was. */
  dry(): void {
    this.#soaked.braking.dry(this.#points);
  }
}
