import { Shell, type ShellSettings } from '../../../../physics-core/solver/deformables/shell.js';
import { volumeOf, type Mesh } from './helpers.js';

/** A ball of rubber: Pa, metres, kg. */
export const E = 1e6;
export const THICKNESS = 1e-3;
export const RADIUS = 0.5;

export const shell = ({ points, index }: Mesh, more: Partial<ShellSettings> = {}): Shell =>
  new Shell(points, index, {
    mass: 3,
    youngsModulus: E,
    poissonsRatio: 0.4,
    thickness: THICKNESS,
    pressure: 5,
    ...more,
  });

/** m³ inside. */
export const within = ({ masses, surface }: Shell): number => {
  surface.follow(masses);
  return volumeOf(surface.places, surface.triangles);
};

/** Steps of 1/60 s, in no more parts than `most`. */
export function step(ball: Shell, steps: number, braking: number, most: number): void {
  const { places, velocities } = ball.masses;
  for (let n = 0; n < steps; n++) {
    const parts = Math.min(most, ball.parts(1 / 60));
    ball.soften(parts, 1 / 60);
    const h = 1 / 60 / parts;
    for (let part = 0; part < parts; part++) {
      ball.push(h);
      for (let j = 0; j < places.length; j++) {
        velocities[j]! /= 1 + braking * h;
        places[j]! += h * velocities[j]!;
      }
    }
  }
}
