import { test } from 'node:test';
import type { Lattice } from '../../../../physics-core/solver/deformables/lattice.js';
import { below } from '../../helpers.js';
import { ballMesh, moving } from './helpers.js';
import { box, shake, solid } from './lattices.js';

/** How far points are, at most, from a body at rest that is only turned: by how far they are apart. */
function deformed({ masses }: Lattice, rest: Float64Array): number {
  let most = 0;
  const apart = (at: Float64Array, a: number, b: number): number =>
    Math.sqrt([0, 1, 2].reduce((sum, k) => sum + (at[3 * a + k]! - at[3 * b + k]!) ** 2, 0));
  for (let a = 0; a < masses.count; a++)
    for (let b = a + 1; b < masses.count; b += 3)
      most = Math.max(most, Math.abs(apart(masses.places, a, b) - apart(rest, a, b)));
  return most;
}

// ---- what befalls it ---------------------------------------------------------------------------------------------------

const CRUSHED: Record<string, (places: Float64Array) => void> = {
  'pressed flat': (places) => places.forEach((p, j) => (places[j] = j % 3 === 2 ? 0 : p)),
  'turned inside out': (places) => places.forEach((p, j) => (places[j] = j % 3 === 2 ? -p : p)),
  'crushed to a tenth': (places) => places.forEach((p, j) => (places[j] = 0.1 * p)),
  scrambled: (places) => {
    places.fill(0);
    shake(places, 0.5);
  },
};

/** Crushes it, lets it go, and brakes it for twenty seconds. */
function crushed(lattice: Lattice, crush: (places: Float64Array) => void): void {
  const { places, velocities } = lattice.masses;
  crush(places);
  shake(places, 1e-6);
  for (let step = 0; step < 1200; step++) {
    const parts = lattice.parts(1 / 60);
    below(parts, 100, 'parts');
    const h = 1 / 60 / parts;
    for (let part = 0; part < parts; part++) {
      lattice.push(h);
      for (let j = 0; j < places.length; j++) {
        velocities[j]! /= 1 + 3 * h;
        places[j]! += h * velocities[j]!;
      }
    }
  }
}

for (const [how, crush] of Object.entries(CRUSHED))
  for (const poissonsRatio of [0, 0.3, 0.45])
    test(`a cube that is ${how} comes back, at ${poissonsRatio}`, () => {
      const lattice = box([1, 1, 1], { poissonsRatio, resolution: 3 });
      const rest = lattice.masses.places.slice();
      crushed(lattice, crush);
      below(deformed(lattice, rest), 1e-6);
    });

test('nothing that flings it gives it more energy than that', () => {
  const lattice = box([1, 1, 1], { resolution: 4 });
  const { places, velocities } = lattice.masses;
  // Six times the speed of sound.
  shake(velocities, 200);
  const start = moving(lattice.masses);
  for (let step = 0; step < 120; step++) {
    const parts = Math.min(4, lattice.parts(1 / 60));
    lattice.soften(parts, 1 / 60);
    const h = 1 / 60 / parts;
    for (let part = 0; part < parts; part++) {
      lattice.push(h);
      for (let j = 0; j < places.length; j++) places[j]! += h * velocities[j]!;
    }
    below(moving(lattice.masses), 1.5 * start);
  }
});

test('a ball comes back from flat, too, though its cells are parts of cells', () => {
  for (const poissonsRatio of [0.1, 0.3, 0.45]) {
    const lattice = solid(ballMesh(0.5, 3), 50, { poissonsRatio, resolution: 5 });
    const rest = lattice.masses.places.slice();
    crushed(lattice, CRUSHED['pressed flat']!);
    below(deformed(lattice, rest), 1e-2);
  }
});
