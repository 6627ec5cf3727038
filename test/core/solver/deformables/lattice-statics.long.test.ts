import { test } from 'node:test';
import { close, type Vec3 } from '../../helpers.js';
import { cos, sin } from '../../../../physics-core/base/exact/index.js';
import { fineBoxMesh, holding, type Mesh, Run, volumeOf } from './helpers.js';
import { box, DENSITY, E, solid } from './lattices.js';

// ---- statics -----------------------------------------------------------------------------------------------------------

for (const [poissonsRatio, miss] of [
  [0, 1e-4],
  [0.3, 2e-3],
] as const)
  test(`a bar that hangs is longer by ρ g L² / 2 E, at ${poissonsRatio}`, () => {
    const lattice = box([0.1, 0.8, 0.1], { poissonsRatio });
    const run = new Run(lattice, () => {
      for (const i of run.at(1, 0.8)) lattice.masses.velocities[3 * i + 1] = 0;
    });
    run.settle(4 * 0.8 * Math.sqrt(DENSITY / E), [0, -0.1, 0]);
    const longer = (DENSITY * 0.1 * 0.8 ** 2) / (2 * E);
    close(-run.gone(run.at(1, 0), 1), longer, miss * longer);
  });

/** Metres by which a beam's end goes down under its own weight: by its bending, and by shear (Timoshenko, Cowper). */
function sags(
  [length, height, width]: Readonly<Vec3>,
  poissonsRatio: number,
  gravity: number,
): number {
  const load = DENSITY * gravity * height * width;
  const bending = (load * length ** 4) / (8 * E * ((width * height ** 3) / 12));
  const shear = E / (2 * (1 + poissonsRatio));
  const share = (10 * (1 + poissonsRatio)) / (12 + 11 * poissonsRatio);
  return bending + (load * length ** 2) / (2 * share * shear * height * width);
}

const BEAMS: Vec3[] = [
  [0.8, 0.1, 0.1],
  [0.8, 0.2, 0.2],
  [0.8, 0.2, 0.1],
  [0.8, 0.05, 0.05],
];

for (const size of BEAMS)
  for (const poissonsRatio of [0, 0.3, 0.49])
    test(`a beam of ${size.join(' × ')} m sags as beams do, with eight cells along it, at ${poissonsRatio}`, () => {
      const lattice = box(size, { poissonsRatio });
      const { velocities } = lattice.masses;
      // Its root may grow narrower, as beam theory has it.
      const run = new Run(lattice, () => {
        const root = run.at(0, 0);
        for (const i of root) velocities[3 * i] = 0;
        for (const k of [1, 2]) {
          const mean = root.reduce((sum, i) => sum + velocities[3 * i + k]!, 0) / root.length;
          for (const i of root) velocities[3 * i + k]! -= mean;
        }
      });
      const slowest = (3.516 / size[0] ** 2) * Math.sqrt((E * size[1] ** 2) / (12 * DENSITY));
      run.settle((2 * Math.PI) / slowest, [0, -0.01, 0]);
      const end = run.at(0, size[0]);
      const root = run.gone(run.at(0, 0), 1);
      const expected = sags(size, poissonsRatio, 0.01);
      close(root - run.gone(end, 1), expected, 0.05 * expected);
    });

test('what is walled in sags by no more than a tenth less', () => {
  const lattice = box([0.8, 0.2, 0.2], { poissonsRatio: 0.3 });
  const run = new Run(lattice);
  holding(lattice, run.at(0, 0));
  run.settle(2.5, [0, -0.01, 0]);
  const expected = sags([0.8, 0.2, 0.2], 0.3, 0.01);
  close(-run.gone(run.at(0, 0.8), 1), expected, 0.1 * expected);
});

test('what is all but incompressible keeps its volume when it is pressed', () => {
  const mesh = fineBoxMesh([1, 1, 1], 4);
  const lattice = solid(mesh, 100, { poissonsRatio: 0.49, resolution: 4 });
  const run = new Run(lattice, () => {
    for (const i of run.at(1, 1)) lattice.masses.velocities[3 * i + 1] = run.time < 1 ? -0.2 : 0;
    for (const i of run.at(1, 0)) lattice.masses.velocities[3 * i + 1] = 0;
  });
  run.go(1, [0, 0, 0], 5).settle(0.2);
  lattice.surface.follow(lattice.masses);
  close(volumeOf(lattice.surface.places, lattice.surface.triangles), 1, 0.01, 'volume');
  close(run.gone(run.at(1, 1), 1), -0.2, 0.01, 'pressed');
});

/** A round bar along x, its ends flat. */
function roundBar(length: number, radius: number): Mesh {
  const around = 48;
  const points = [0, 0, 0, length, 0, 0];
  const index: number[] = [];
  for (let i = 0; i < around; i++) {
    const angle = (2 * Math.PI * i) / around;
    const [y, z] = [radius * cos(angle), radius * sin(angle)];
    points.push(0, y, z, length, y, z);
    const a = 2 + 2 * i;
    const b = 2 + 2 * ((i + 1) % around);
    index.push(0, b, a, 1, a + 1, b + 1, a, b, b + 1, a, b + 1, a + 1);
  }
  return { points, index };
}

test('a round bar sags as beams do, to a tenth, though no cell of it is whole', () => {
  const [length, radius] = [0.8, 0.1];
  const area = Math.PI * radius ** 2;
  const lattice = solid(roundBar(length, radius), DENSITY * area * length, { poissonsRatio: 0 });
  const run = new Run(lattice);
  holding(lattice, run.at(0, 0));
  run.settle(2.5, [0, -0.01, 0]);
  const load = DENSITY * 0.01 * area;
  const bending = (load * length ** 4) / (8 * E * ((Math.PI / 4) * radius ** 4));
  // By shear, for what is round (Cowper): 6 / 7.
  const expected = bending + (load * length ** 2) / (2 * (6 / 7) * (E / 2) * area);
  close(-run.gone(run.at(0, length), 1), expected, 0.1 * expected);
});
