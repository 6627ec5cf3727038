import { add, dot, length, scale, subtract } from '../../base/math.js';
import type { Vec3 } from '../../fields/types.js';

/** Places that it goes through. With so many, what is shaken by 10 cm twice a second is right to 1 µm/s at 1/240 s. */
const PLACES = 5;

/** Of changes of pace, how much may change from one to the next but one: a sine does with twelve places in a turn. */
const SMOOTH = 0.5;

/** m/s: changes of pace that are none. */
const STEADY = 1e-5;

export interface PlaceInTime {
  time: number;
  p: Vec3;
}

/** A way in time, by rising powers of the seconds since a step began. */
export class StepWay {
  readonly #powers: readonly Vec3[];

  constructor(powers: readonly Vec3[]) {
    this.#powers = powers;
  }

  place(t: number): Vec3 {
    return this.#derivative(0, t);
  }

  velocity(t: number): Vec3 {
    return this.#derivative(1, t);
  }

  acceleration(t: number): Vec3 {
    return this.#derivative(2, t);
  }

  #derivative(order: 0 | 1 | 2, t: number): Vec3 {
    const sum: Vec3 = [0, 0, 0];
    for (let k = this.#powers.length - 1; k >= order; k--) {
      const factor = order === 0 ? 1 : order === 1 ? k : k * (k - 1);
      for (let i = 0; i < 3; i++) sum[i] = sum[i]! * t + factor * this.#powers[k]![i]!;
    }
    return sum;
  }
}

/** What of a vector lies in a plane. */
export const flat = (v: Vec3, normal: Vec3): Vec3 => subtract(v, scale(normal, dot(v, normal)));

/**
 * Where what its author moves is within a step. He tells where it is to be at the end of each move only, but at the
 * beginning and the end of a step it has other speeds than that of the move: they are those of a polynomial through its last places.
 */
export class SmoothWay {
  /** Where its moves began, the last one first. */
  readonly #begun: PlaceInTime[] = [];

  get begun(): readonly PlaceInTime[] {
    return this.#begun;
  }

  set begun(begun: readonly PlaceInTime[]) {
    this.#begun.splice(0, Infinity, ...begun);
  }

  /** A move begins. */
  begin(time: number, p: Vec3): void {
    this.#begun.unshift({ time, p });
    if (this.#begun.length === PLACES) this.#begun.pop();
  }

  /** It jumped: what came before is no part of its way. */
  forget(): void {
    this.#begun.length = 0;
  }

  /** In the step that begins at a time, with its move ending there; undefined: it goes no smooth way. */
  from(time: number, end: PlaceInTime): StepWay | undefined {
    const places = [end, ...this.#begun];
    return places.length > 2 && isSmooth(places) ? new StepWay(through(places, time)) : undefined;
  }
}

/** Whether its pace changes evenly. What starts, stops or turns at once does not. */
function isSmooth(places: readonly PlaceInTime[]): boolean {
  if (places.length < PLACES) return true;
  const paces = differences(places).map((step, i) =>
    scale(step, 1 / (places[i]!.time - places[i + 1]!.time)),
  );
  const changes = paces.slice(1).map((pace, i) => subtract(paces[i]!, pace));
  const [first, second, third] = changes as [Vec3, Vec3, Vec3];
  const change = length(add(subtract(first, scale(second, 2)), third));
  return change <= STEADY + SMOOTH * Math.max(...changes.map(length));
}

const differences = (places: readonly PlaceInTime[]): Vec3[] =>
  places.slice(1).map(({ p }, i) => subtract(places[i]!.p, p));

/** The polynomial through some places, by rising powers of the time since `from`, by Newton's divided differences. */
export function through(places: readonly PlaceInTime[], from: number): Vec3[] {
  const times = places.map(({ time }) => time - from);
  let column = places.map(({ p }) => p);
  const newton = [column[0]!];
  for (let order = 1; order < places.length; order++) {
    column = column
      .slice(1)
      .map((next, i) => scale(subtract(next, column[i]!), 1 / (times[i + order]! - times[i]!)));
    newton.push(column[0]!);
  }
  return newton.reduceRight<Vec3[]>((powers, c, i) => timesLinear(powers, times[i]!, c), []);
}

/** A polynomial times (t - root), and a number more. */
function timesLinear(powers: readonly Vec3[], root: number, more: Vec3): Vec3[] {
  const product = [more, ...powers];
  powers.forEach((c, k) => (product[k] = subtract(product[k]!, scale(c, root))));
  return product;
}
