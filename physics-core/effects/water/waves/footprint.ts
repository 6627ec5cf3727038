import { grown } from '../../../base/grown.js';
import type { Flat } from '../../../shapes/cut/cut.js';
import { LEAST_CELLS } from '../tolerances.js';
import type { WaveField } from './field.js';

/** Along one side of the field: which cells count how much, and how that changes as the middle goes along. */
class Weights {
  first = 0;
  count = 0;
  /** They add up to 1. */
  each: Flat = new Float64Array(16);
  slopes: Flat = new Float64Array(16);
  /** Of their squares. */
  squares = 0;

  /** (1 - t²)² of how far it is, t = 1 at `radius`; `middle` in metres from the first edge. */
  take(middle: number, radius: number, cell: number, cells: number): void {
    const at = Math.min(cells, Math.max(0, middle / cell));
    const reach = Math.max(LEAST_CELLS, radius / cell);
    this.first = Math.max(0, Math.ceil(at - reach - 0.5));
    this.count = Math.min(cells - 1, Math.floor(at + reach - 0.5)) - this.first + 1;
    if (this.each.length < this.count) {
      this.each = grown(this.each, 2 * this.count);
      this.slopes = grown(this.slopes, 2 * this.count);
    }
    this.#weigh(at, reach, cell);
  }

  #weigh(at: number, reach: number, cell: number): void {
    const { first, count, each, slopes } = this;
    let sum = 0;
    let slope = 0;
    for (let i = 0; i < count; i++) {
      const t = (first + i + 0.5 - at) / reach;
      const left = Math.max(0, 1 - t * t);
      each[i] = left * left;
      slopes[i] = (4 * t * left) / (reach * cell);
      sum += each[i]!;
      slope += slopes[i]!;
    }
    this.squares = 0;
    for (let i = 0; i < count; i++) {
      const weight = each[i]! / sum;
      each[i] = weight;
      slopes[i] = (slopes[i]! - weight * slope) / sum;
      this.squares += weight * weight;
    }
  }
}

/**
 * Where a body is in a field: what it displaces is spread by the same weights by which it feels the height, and it feels
 * the slope by how that height changes as it goes along. So what a body gains by waves they lose.
 */
export class Footprint {
  readonly #field: WaveField;
  readonly #across = new Weights();
  readonly #along = new Weights();
  /** What is felt there: metres, and metres a metre along the width and the length. */
  height = 0;
  acrossSlope = 0;
  alongSlope = 0;
  /** What flows there along both, m²/s. */
  acrossFlow = 0;
  alongFlow = 0;

  constructor(field: WaveField) {
    this.#field = field;
  }

  /** Around a point, metres from the field's middle. */
  place(across: number, along: number, width: number, length: number): void {
    const field = this.#field;
    this.#across.take(across + field.width / 2, width, field.cellWidth, field.columns);
    this.#along.take(along + field.length / 2, length, field.cellLength, field.rows);
  }

  /** How much surface a volume lifts that is spread over it by as much as is felt there then, m². */
  get area(): number {
    return this.#field.cellArea / (this.#across.squares * this.#along.squares);
  }

  feel(): void {
    const { heights, columns } = this.#field;
    const { first, count, each, slopes } = this.#across;
    const along = this.#along;
    this.height = this.acrossSlope = this.alongSlope = 0;
    for (let j = 0; j < along.count; j++) {
      const start = (along.first + j) * columns + first;
      let height = 0;
      let slope = 0;
      for (let i = 0; i < count; i++) {
        height += each[i]! * heights[start + i]!;
        slope += slopes[i]! * heights[start + i]!;
      }
      this.height += along.each[j]! * height;
      this.acrossSlope += along.each[j]! * slope;
      this.alongSlope += along.slopes[j]! * height;
    }
  }

  feelFlow(): void {
    const { alongWidth, alongLength, columns } = this.#field;
    const { first, count, each } = this.#across;
    const along = this.#along;
    this.acrossFlow = this.alongFlow = 0;
    for (let j = 0; j < along.count; j++) {
      const row = along.first + j;
      const start = row * columns + first;
      let across = 0;
      let onward = 0;
      for (let i = 0; i < count; i++) {
        const at = start + i;
        across += each[i]! * (alongWidth[at + row]! + alongWidth[at + row + 1]!);
        onward += each[i]! * (alongLength[at]! + alongLength[at + columns]!);
      }
      this.acrossFlow += (along.each[j]! * across) / 2;
      this.alongFlow += (along.each[j]! * onward) / 2;
    }
  }

  /** m³ come to stand there. */
  raise(volume: number): void {
    const { heights, columns, cellArea } = this.#field;
    const { first, count, each } = this.#across;
    const along = this.#along;
    for (let j = 0; j < along.count; j++) {
      const start = (along.first + j) * columns + first;
      const share = (along.each[j]! * volume) / cellArea;
      for (let i = 0; i < count; i++) heights[start + i] = heights[start + i]! + share * each[i]!;
    }
  }

  /** Its water is pushed by so many m⁴/s: newton seconds by its density. Walls take what goes against them. */
  push(across: number, along: number): void {
    const { alongWidth, alongLength, columns, rows, cellArea } = this.#field;
    const a = this.#across;
    const b = this.#along;
    for (let j = 0; j < b.count; j++) {
      const row = b.first + j;
      for (let i = 0; i < a.count; i++) {
        const column = a.first + i;
        const share = (a.each[i]! * b.each[j]!) / cellArea / 2;
        const at = row * columns + column;
        add(alongWidth, at + row, share * across, column > 0);
        add(alongWidth, at + row + 1, share * across, column + 1 < columns);
        add(alongLength, at, share * along, row > 0);
        add(alongLength, at + columns, share * along, row + 1 < rows);
      }
    }
  }
}

function add(flows: Flat, at: number, value: number, inside: boolean): void {
  if (inside) flows[at] = flows[at]! + value;
}
