import { x3dom, type X3DNode } from '../x3dom/x3dom.js';

interface Box {
  setBounds(min: object, max: object): void;
  valid?: boolean;
}

/** Room beside what particles take: they move on, and x3dom measures all of its scene anew when the box is another. */
const ROOM = 0.5;

/** The box around all particles of a Shape: x3dom draws nothing nearer or farther than what it knows of. */
export class Bounds {
  readonly #shape: X3DNode;
  readonly #box: Box;
  /** What x3dom knows. */
  #lower = [Infinity, Infinity, Infinity];
  #upper = [-Infinity, -Infinity, -Infinity];

  constructor(shape: X3DNode) {
    this.#shape = shape;
    const box = new (x3dom()!.fields.BoxVolume)();
    this.#box = box as Box;
    shape.getVolume = () => box;
  }

  /** Points flat, each of which reaches so far from where it is. */
  around(points: ArrayLike<number>, reach: number): void {
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < points.length; i++) {
      const value = points[i]!;
      if (value < low[i % 3]!) low[i % 3] = value;
      if (value > high[i % 3]!) high[i % 3] = value;
    }
    this.hold(low, high, reach);
  }

  /** Particles are from `low` to `high`, and each reaches so far from where it is. */
  hold(low: readonly number[], high: readonly number[], reach: number): void {
    if (!(low[0]! <= high[0]!) || this.#holds(low, high, reach)) return;
    const room = reach + ROOM * Math.max(...low.map((value, i) => high[i]! - value));
    this.#lower = low.map((value) => value - room);
    this.#upper = high.map((value) => value + room);
    const { SFVec3f } = x3dom()!.fields;
    const point = ([x, y, z]: number[]): object => new SFVec3f(x!, y!, z!);
    this.#box.setBounds(point(this.#lower), point(this.#upper));
    this.#box.valid = true;
    for (const parent of this.#shape._parentNodes) parent.invalidateVolume();
  }

  #holds(low: readonly number[], high: readonly number[], reach: number): boolean {
    for (let i = 0; i < 3; i++)
      if (low[i]! - reach < this.#lower[i]! || high[i]! + reach > this.#upper[i]!) return false;
    return true;
  }
}
