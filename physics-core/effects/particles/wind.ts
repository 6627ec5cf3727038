import { Cap } from './emit/cap.js';
import type { Draws } from './emit/draws.js';
import type { Vec3 } from '../../fields/types.js';
import type { WindSettings } from './settings.js';

/** Gusts last so long, seconds: the longest step, so that each level has the same ones. */
export const GUST = 1 / 60;

/** Pascal of a wind of 1 m/s: ISO/IEC 19775-1, 40.4.9 has 10^(2 log₁₀ speed) · 0.64615. */
export const PRESSURE = 0.64615;

/** A kind of random numbers is one gust's. */
const GUSTS = 1;

/** How a wind pushes, gust by gust. */
export class Wind {
  readonly #settings: WindSettings;
  readonly #draws: Draws;
  readonly #kind: number;
  /** Where this gust goes, and how it pushes, m/s², what has such an area and mass. */
  readonly #direction = new Float64Array(3);
  readonly #cap = new Cap();
  #push = 0;
  #speed = 0;
  #gust = 0;

  /** The `n`-th wind of a system. */
  constructor(settings: WindSettings, draws: Draws, n: number) {
    this.#settings = settings;
    this.#draws = draws;
    this.#kind = GUSTS + n;
  }

  /** Whether each particle goes another way. */
  get whirls(): boolean {
    return this.#settings.turbulence > 0;
  }

  /** The `gust`-th begins. `area`: of a particle, m² by kg. */
  begin(gust: number, area = 0): void {
    const { direction, speed, gustiness } = this.#settings;
    this.#gust = gust;
    const draws = this.#draws.of(gust, this.#kind);
    const now = Math.max(0, speed * (1 + gustiness * draws.either()));
    this.#speed = now;
    this.#push = PRESSURE * now * now * area;
    this.#cap.take(direction[0], direction[1], direction[2], 0).draw(draws, this.#direction, 0);
    const [x, y, z] = this.#direction as unknown as Vec3;
    if (this.whirls) this.#cap.take(x, y, z, Math.PI * this.#settings.turbulence);
  }

  /** Adds what the gust does to all alike, m/s². */
  addToAll(out: Float64Array): void {
    for (let i = 0; i < 3; i++) out[i] = out[i]! + this.#push * this.#direction[i]!;
  }

  /** Adds what it does to the `number`-th particle. */
  addTo(number: number, out: Float64Array): void {
    this.#drawWay(number);
    for (let i = 0; i < 3; i++) out[i] = out[i]! + this.#push * way[i]!;
  }

  /** How it blows, m/s, about the body of such an id. */
  writeAbout(id: number, out: Float64Array): void {
    if (this.whirls) this.#drawWay(-1 - id);
    const from = this.whirls ? way : this.#direction;
    for (let i = 0; i < 3; i++) out[i] = this.#speed * from[i]!;
  }

  /** Particles are numbered from 0 on, bodies below that. */
  #drawWay(number: number): void {
    const draws = this.#draws.of(number, this.#kind + WHIRLS * (this.#gust + 1));
    this.#cap.draw(draws, way, 0);
  }
}

/** More than there are winds of a system. */
const WHIRLS = 1024;

const way = new Float64Array(3);
