/** Spots on a link, at most: at either end of what it lies on. */
export const SPOTS = 2;

/** What touches nothing any more is not pushed in the next step, and in the one after it was not. */
const STEPS = 2;

/** Where a strand may touch something: at its points, or between two of them, where a link comes nearest to it. */
export class Spots {
  readonly count: number;
  /** Of each, the point behind it, and its share of the way from there to the next one. */
  readonly firsts: Int32Array;
  readonly shares: Float64Array;
  /** For so many steps any of them may be pushed, or may have been: 0 costs nothing. */
  recent = 0;

  // ---- from step to step --------------------------------------------------------------------------------------------

  /** How what it touches pushed and rubbed it, N s: along the normal, and along the surface. */
  readonly presses: Float64Array;
  readonly rubs: Float64Array;
  /** The same in the step before. */
  readonly pressed: Float64Array;
  readonly rubbed: Float64Array;

  // ---- a step -------------------------------------------------------------------------------------------------------

  /** 1: there is something to touch. */
  readonly touches: Uint8Array;
  readonly normals: Float64Array;
  /** How far away that is when the step begins, metres; how fast it is, m/s. */
  readonly gaps: Float64Array;
  readonly surfaces: Float64Array;
  readonly frictions: Float64Array;
  /** How it gives way: m/s for each N s. */
  readonly yields: Float64Array;

  /** So many on each of so many points or links. */
  constructor(owners: number, each: number) {
    const count = owners * each;
    this.count = count;
    this.firsts = Int32Array.from({ length: count }, (_, c) => Math.floor(c / each));
    this.shares = new Float64Array(count);
    this.presses = new Float64Array(count);
    this.rubs = new Float64Array(3 * count);
    this.pressed = new Float64Array(count);
    this.rubbed = new Float64Array(3 * count);
    this.touches = new Uint8Array(count);
    this.normals = new Float64Array(3 * count);
    this.gaps = new Float64Array(count);
    this.surfaces = new Float64Array(3 * count);
    this.frictions = new Float64Array(count);
    this.yields = new Float64Array(count);
  }

  begin(): void {
    if (this.recent === 0) return;
    this.recent--;
    for (let c = 0; c < this.count; c++) this.pressed[c] = this.presses[c]!;
    for (let j = 0; j < 3 * this.count; j++) this.rubbed[j] = this.rubs[j]!;
  }

  /** There is something to touch. */
  touch(c: number): void {
    this.touches[c] = 1;
    this.recent = STEPS;
  }

  /** Nobody knows what they were held by: somebody may write it. */
  restore(): void {
    this.recent = STEPS;
  }

  /** One takes over what another one was held by. */
  inherit(c: number, from: number): void {
    const { presses, rubs, pressed, rubbed } = this;
    if (pressed[from] === 0) return;
    presses[c]! += presses[from]!;
    pressed[c]! += pressed[from]!;
    presses[from] = pressed[from] = 0;
    for (let k = 0; k < 3; k++) {
      rubs[3 * c + k]! += rubs[3 * from + k]!;
      rubbed[3 * c + k]! += rubbed[3 * from + k]!;
      rubs[3 * from + k] = rubbed[3 * from + k] = 0;
    }
  }
}
