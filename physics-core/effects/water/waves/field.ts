import type { Flat } from '../../../shapes/cut/cut.js';
import { COURANT } from '../tolerances.js';

/** How a surface is divided. */
export interface Grid {
  /** Cells along its width and along its length. */
  readonly columns: number;
  readonly rows: number;
  /** Metres. */
  readonly width: number;
  readonly length: number;
}

/** What waves go by. */
export interface Conditions {
  /** Of the still water, metres. */
  readonly depth: number;
  /** Into the water, m/s². */
  readonly gravity: number;
  /** Waves go out at the edges; else these are walls. */
  readonly open: boolean;
  /** Share of its speed that the water loses in a second. */
  readonly damping: number;
}

/**
 * The surface of shallow water: linear waves, all of which go at √(g h). Heights stand in the middles of cells, and what
 * flows on their sides, half a step earlier (leapfrog): waves neither grow nor die by themselves, and what leaves a cell
 * comes into the next one to the last bit.
 */
export class WaveField implements Grid {
  readonly columns: number;
  readonly rows: number;
  readonly width: number;
  readonly length: number;
  /** Of a cell: along both, metres, and m². */
  readonly cellWidth: number;
  readonly cellLength: number;
  readonly cellArea: number;
  /** Above the still water, metres, row by row. */
  readonly heights: Flat;
  /** What flows along the width and the length through a metre of a side, m²/s: each cell's first sides, row by row, then the last ones. */
  readonly alongWidth: Flat;
  readonly alongLength: Flat;
  /** The highest of its heights, metres; 0 where all lie below. */
  crest = 0;
  #conditions: Conditions = { depth: 1, gravity: 0, open: false, damping: 0 };

  constructor({ columns, rows, width, length }: Grid) {
    this.columns = columns;
    this.rows = rows;
    this.width = width;
    this.length = length;
    this.cellWidth = width / columns;
    this.cellLength = length / rows;
    this.cellArea = this.cellWidth * this.cellLength;
    this.heights = new Float64Array(columns * rows);
    this.alongWidth = new Float64Array((columns + 1) * rows);
    this.alongLength = new Float64Array(columns * (rows + 1));
  }

  get conditions(): Conditions {
    return this.#conditions;
  }

  set conditions(conditions: Conditions) {
    this.#conditions = conditions;
    // What has become a wall lets nothing through.
    if (!conditions.open) this.#shut();
  }

  /** Of waves, m/s. */
  get speed(): number {
    const { depth, gravity } = this.#conditions;
    return Math.sqrt(Math.max(0, gravity * depth));
  }

  /** Between the middles of cells, by how far a place is from its own; beyond the last ones as there. */
  heightAt(across: number, along: number): number {
    const { columns, rows, heights } = this;
    const x = Math.min(columns - 1, Math.max(0, (across + this.width / 2) / this.cellWidth - 0.5));
    const z = Math.min(rows - 1, Math.max(0, (along + this.length / 2) / this.cellLength - 0.5));
    const i = Math.floor(x);
    const j = Math.floor(z);
    const right = Math.min(i + 1, columns - 1);
    const next = Math.min(j + 1, rows - 1);
    const near = heights[j * columns + i]! * (1 - x + i) + heights[j * columns + right]! * (x - i);
    const far =
      heights[next * columns + i]! * (1 - x + i) + heights[next * columns + right]! * (x - i);
    return near * (1 - z + j) + far * (z - j);
  }

  step(dt: number): void {
    const perSecond = this.speed * Math.sqrt(1 / this.cellWidth ** 2 + 1 / this.cellLength ** 2);
    const parts = Math.max(1, Math.ceil((dt * perSecond) / COURANT));
    for (let i = 0; i < parts; i++) {
      this.#flow(dt / parts);
      if (this.#conditions.open) this.#leave();
      this.#rise(dt / parts);
    }
  }

  /** It flows down its slopes. */
  #flow(dt: number): void {
    const { columns, rows, heights, alongWidth, alongLength } = this;
    const { depth, gravity, damping } = this.#conditions;
    const half = (damping * dt) / 2;
    const kept = (1 - half) / (1 + half);
    const down = (gravity * depth * dt) / (1 + half);
    const across = down / this.cellWidth;
    const along = down / this.cellLength;
    for (let row = 0; row < rows; row++) {
      const first = row * columns;
      const side = row * (columns + 1);
      for (let i = 1; i < columns; i++) {
        const fall = heights[first + i - 1]! - heights[first + i]!;
        alongWidth[side + i] = kept * alongWidth[side + i]! + across * fall;
      }
      if (row === 0) continue;
      for (let at = first; at < first + columns; at++)
        alongLength[at] = kept * alongLength[at]! + along * (heights[at - columns]! - heights[at]!);
    }
  }

  /** What comes to an open edge goes on at its speed (Sommerfeld's condition). */
  #leave(): void {
    const { columns, rows, heights, alongWidth, alongLength, speed } = this;
    for (let row = 0; row < rows; row++) {
      alongWidth[row * (columns + 1)] = -speed * heights[row * columns]!;
      alongWidth[row * (columns + 1) + columns] = speed * heights[row * columns + columns - 1]!;
    }
    const last = (rows - 1) * columns;
    for (let i = 0; i < columns; i++) {
      alongLength[i] = -speed * heights[i]!;
      alongLength[rows * columns + i] = speed * heights[last + i]!;
    }
  }

  #shut(): void {
    const { columns, rows, alongWidth, alongLength } = this;
    for (let row = 0; row < rows; row++)
      alongWidth[row * (columns + 1)] = alongWidth[row * (columns + 1) + columns] = 0;
    alongLength.fill(0, 0, columns);
    alongLength.fill(0, rows * columns);
  }

  /** What flows in lifts it. */
  #rise(dt: number): void {
    const { columns, rows, heights, alongWidth, alongLength } = this;
    const across = dt / this.cellWidth;
    const along = dt / this.cellLength;
    let crest = 0;
    for (let row = 0; row < rows; row++) {
      const first = row * columns;
      for (let i = 0; i < columns; i++) {
        const at = first + i;
        const side = at + row;
        const height =
          heights[at]! +
          across * (alongWidth[side]! - alongWidth[side + 1]!) +
          along * (alongLength[at]! - alongLength[at + columns]!);
        heights[at] = height;
        if (height > crest) crest = height;
      }
    }
    this.crest = crest;
  }

  /** Of all heights, metres. */
  get level(): number {
    let sum = 0;
    for (const height of this.heights) sum += height;
    return sum / this.heights.length;
  }

  /** Whether nothing of it is farther from its level than that, metres, and flows faster than waves so high would. */
  isStill(within: number): boolean {
    const { heights, level } = this;
    for (const height of heights) if (Math.abs(height - level) > within) return false;
    const most = within * this.speed;
    return isBelow(this.alongWidth, most) && isBelow(this.alongLength, most);
  }

  /** It is flat, and stands. */
  calm(level: number): void {
    this.heights.fill(level);
    this.alongWidth.fill(0);
    this.alongLength.fill(0);
    this.crest = Math.max(0, level);
  }
}

function isBelow(flows: Flat, most: number): boolean {
  for (const flow of flows) if (Math.abs(flow) > most) return false;
  return true;
}
