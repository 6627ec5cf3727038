import type { Vec3 } from '../case.js';
import { ball, box } from '../price/scene.js';

/** A body that particles meet; metres. */
export interface Body {
  position: Vec3;
  shape: ReturnType<typeof ball> | ReturnType<typeof box>;
  /** Radians per second. */
  spin: Vec3;
}

/** In layers of so many by so many, metres apart, from a height on: they never meet each other. */
const [ROW, APART, LOWEST] = [5, 2, 1];

/** Boxes and balls that hang about the fountain, none right above where it begins, and turn: so all stays as it is. */
export const hanging = (count: number): Body[] =>
  Array.from({ length: count }, (_, i) => {
    const [column, row, layer] = [i % ROW, Math.floor(i / ROW) % ROW, Math.floor(i / ROW ** 2)];
    const at = (place: number): number => APART * (place - ROW / 2);
    return {
      position: [at(column), LOWEST + 2 * APART * layer, at(row)],
      shape: i % 2 ? ball(0.4) : box(0.8, 0.5, 0.6),
      spin: [0.3, 0.5, 0.2],
    };
  });
