import { add, cross, quaternionOf, rotate, scale } from '../physics-core/base/math.js';
import type { Rotation, Vec3 } from '../physics-core/fields/types.js';

/** A disc of 1 kg on a stick, whose tip is a ball that rolls on the plane y = 0. */
export interface SteadyTop {
  /** Of the tip, and from its middle to the centre of mass, metres. */
  tip: number;
  arm: number;
  /** Across its axis and about it, kg m². */
  across: number;
  about: number;
  /** Radians from the vertical, and how fast it goes round, rad/s. */
  lean: number;
  round: number;
  /** m/s² */
  gravity: number;
}

/**
 * How it leans and goes round steadily. What gravity and the floor turn it by is what its angular momentum, going round,
 * needs; that says how fast it spins besides. Where the tip touches nothing slips.
 */
export function steadyTop({ tip, arm, across, about, lean, round, gravity }: SteadyTop) {
  const height = tip + arm * Math.cos(lean);
  const spins =
    (gravity * arm + round ** 2 * (arm * height + Math.cos(lean) * (across - about))) /
    (round * (about + tip * height));
  const up: Vec3 = [0, 1, 0];
  const axis = rotate(quaternionOf([0, 0, 1, -lean]), up);
  // Of the circle that its centre of mass goes, on the side to which it leans where positive.
  const wide = (arm - (spins * tip) / round) * Math.sin(lean);
  return {
    orientation: [0, 0, 1, -lean] as Rotation,
    spin: add(scale(up, round), scale(axis, spins)),
    velocity: add(scale(cross(axis, up), spins * tip), scale(cross(up, axis), round * arm)),
    path: (time: number): Vec3 => [
      wide * Math.cos(round * time),
      height,
      -wide * Math.sin(round * time),
    ],
  };
}
