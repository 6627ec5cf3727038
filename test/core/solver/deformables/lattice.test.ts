import assert from 'node:assert/strict';
import { test } from 'node:test';
import { above, below, close } from '../../helpers.js';
import {
  ballMesh,
  boxMesh,
  forces,
  momenta,
  moving,
  Run,
  stored,
  turn,
  type Mesh,
} from './helpers.js';
import { box, DENSITY, E, shake, solid } from './lattices.js';

// ---- what it is made of ------------------------------------------------------------------------------------------------

test('a box is filled exactly, and its corners are those of its cells', () => {
  const lattice = box([0.8, 0.4, 0.2]);
  assert.equal(lattice.cells, 8 * 4 * 2, 'cells');
  assert.equal(lattice.masses.count, 9 * 5 * 3, 'points');
  close(
    lattice.masses.masses.reduce((sum, m) => sum + m),
    DENSITY * 0.064,
    1e-12,
    'mass',
  );
  close([...lattice.surface.places], boxMesh([0.8, 0.4, 0.2]).points, 1e-12, 'surface');
});

test('a ball weighs what it is to, around its middle, and shows the surface that was laid', () => {
  const mesh = ballMesh(0.5, 3);
  const lattice = solid(mesh, 3);
  const { masses, places } = lattice.masses;
  close(
    masses.reduce((sum, m) => sum + m),
    3,
    1e-12,
    'mass',
  );
  for (let k = 0; k < 3; k++)
    below(Math.abs(masses.reduce((sum, m, i) => sum + m * places[3 * i + k]!, 0)), 1e-12, 'middle');
  close([...lattice.surface.places], mesh.points, 1e-12, 'surface');
  // As a whole ball that is 2/5 m r²; all mass at the corners of its cells makes it greater.
  const about = masses.reduce(
    (sum, m, i) => sum + m * (places[3 * i]! ** 2 + places[3 * i + 1]! ** 2),
    0,
  );
  close(about, 0.4 * 3 * 0.25, 0.08 * 0.3, 'inertia');
});

test('its surface may look inward, overlap itself or lack a face', () => {
  const one = boxMesh([1, 1, 1]);
  const inward = { points: one.points, index: [...one.index].reverse() };
  assert.equal(solid(inward, 1).cells, 512, 'inward');
  const open = { points: one.points, index: one.index.slice(6) };
  assert.equal(solid(open, 1).cells, 512, 'open');
  const mixed = { points: one.points, index: [...one.index.slice(0, 6).reverse(), ...one.index.slice(6)] }; // prettier-ignore
  assert.equal(solid(mixed, 1).cells, 512, 'mixed');
  const two = {
    points: [...one.points, ...one.points.map((p, j) => p + (j % 3 === 0 ? 0.5 : 0))],
    index: [...one.index, ...one.index.map((i) => i + 8)],
  };
  assert.equal(solid(two, 1).cells, 8 * 5 * 5, 'both');
});

test('what encloses nothing has no points, and nothing comes of asking it', () => {
  const one = boxMesh([1, 1, 1]);
  const nothing: Record<string, Mesh> = {
    none: { points: [], index: [] },
    point: { points: [1, 2, 3], index: [0, 0, 0] },
    flat: boxMesh([1, 1, 0]),
    sheet: { points: one.points, index: one.index.slice(0, 6) },
    nowhere: { points: one.points.map(() => NaN), index: one.index },
    infinite: { points: one.points.map((p) => p * Infinity), index: one.index },
    astray: { points: one.points, index: one.index.map((i) => i + 100) },
  };
  for (const [name, mesh] of Object.entries(nothing)) {
    const lattice = solid(mesh, 1);
    assert.equal(lattice.masses.count, 0, name);
    assert.equal(lattice.parts(1 / 60), 1, name);
    assert.equal(lattice.soften(1, 1 / 60), 1, name);
    lattice.push(1 / 60);
    lattice.stiffen({ youngsModulus: 1, poissonsRatio: 0 });
  }
});

test('a point that is nowhere takes no more with it than its own triangles', () => {
  const mesh = ballMesh(0.5, 3);
  mesh.points[0] = NaN;
  const lattice = solid(mesh, 1);
  above(lattice.cells, 350, 'cells');
  assert.ok(lattice.surface.places.every(Number.isFinite), 'surface');
});

test('cells are no more than thousands, however thin they are asked for', () => {
  below(solid(boxMesh([1, 1, 1]), 1, { resolution: 1000 }).cells, 4097);
});

// ---- forces ------------------------------------------------------------------------------------------------------------

for (const poissonsRatio of [0, 0.3, 0.49])
  test(`what is only turned has no forces, and those of what is deformed turn nothing: ${poissonsRatio}`, () => {
    const lattice = box([0.4, 0.2, 0.1], { poissonsRatio, resolution: 4 });
    const { places } = lattice.masses;
    const rest = places.slice();
    turn(places, 1);
    const push = (time: number): void => lattice.push(time);
    below(Math.max(...forces(lattice, push).map(Math.abs)), 1e-9 * E * 0.01, 'turned');
    shake(places, 0.05);
    const acting = forces(lattice, push);
    const all = acting.reduce((sum, f) => sum + Math.abs(f), 0);
    for (let k = 0; k < 3; k++) {
      const l = (k + 1) % 3;
      const m = (k + 2) % 3;
      let sum = 0;
      let torque = 0;
      for (let i = 0; i < rest.length; i += 3) {
        sum += acting[i + k]!;
        torque += places[i + l]! * acting[i + m]! - places[i + m]! * acting[i + l]!;
      }
      below(Math.abs(sum), 1e-12 * all, 'sum');
      below(Math.abs(torque), 1e-12 * all, 'torque');
    }
  });

test('forces are the slopes of an energy, by whichever way one comes', () => {
  const lattice = box([0.4, 0.2, 0.1], { poissonsRatio: 0.4, resolution: 4 });
  const { places } = lattice.masses;
  const rest = places.slice();
  shake(places, 0.03);
  const acting = forces(lattice, (time) => lattice.push(time));
  for (const j of [0, 7, 20, 31, 52]) {
    const at = places[j]!;
    const energies = [1e-5, -1e-5].map((by) => {
      places[j] = at + by;
      return stored(lattice, rest);
    });
    places[j] = at;
    close(acting[j]!, (energies[1]! - energies[0]!) / 2e-5, 1e-3 * Math.max(...acting), `of ${j}`);
  }
});

// ---- motion ------------------------------------------------------------------------------------------------------------

test('a free bar rings with a period of twice its length over the speed of sound', () => {
  const lattice = box([0.8, 0.1, 0.1], { poissonsRatio: 0 });
  const { velocities } = lattice.masses;
  const run = new Run(lattice);
  const start = run.rest.map((x, j) => (j % 3 === 0 ? 0.001 * (1 - 2 * (x / 0.8)) : 0));
  velocities.set(start);
  const period = 2 * 0.8 * Math.sqrt(DENSITY / E);
  const along = (): number => velocities.reduce((sum, v, j) => sum + v * start[j]!, 0);
  const crossings: number[] = [];
  for (let n = 0, last = along(); n < 2000; n++) {
    const before = run.time;
    const now = (run.go(period / 100), along());
    if (last < 0 && now >= 0) crossings.push(run.time - (now / (now - last)) * (run.time - before));
    last = now;
  }
  close((crossings.at(-1)! - crossings[0]!) / (crossings.length - 1), period, 0.01 * period);
});

/** J, the mean of many moments: places and velocities are half a part apart, by which it goes to and fro. */
function meanEnergy(run: Run): number {
  let sum = 0;
  for (let n = 0; n < 400; n++) {
    run.part(3);
    sum += moving(run.masses) + stored(run.material, run.rest);
  }
  return sum / 400;
}

test('what tumbles and trembles keeps its momenta and its energy', () => {
  const lattice = box([0.4, 0.2, 0.1], { resolution: 4 });
  const { velocities } = lattice.masses;
  const run = new Run(lattice);
  for (let i = 0; i < velocities.length; i += 3) {
    velocities[i] = 1 - 5 * run.rest[i + 1]! + 2 * run.rest[i + 2]!;
    velocities[i + 1] = 5 * run.rest[i]!;
    velocities[i + 2] = -2 * run.rest[i]!;
  }
  shake(velocities, 0.3);
  const first = momenta(lattice.masses);
  const start = meanEnergy(run);
  run.go(20);
  close(meanEnergy(run), start, 2e-3 * start, 'energy');
  const last = momenta(lattice.masses);
  close(last.along, first.along, 1e-12, 'momentum');
  close(last.about, first.about, 1e-12, 'angular momentum');
});

// ---- parts -------------------------------------------------------------------------------------------------------------

test('so many parts as it says are enough, and half of them too few', () => {
  for (const [share, holds] of [
    [1, true],
    [0.5, false],
  ] as const) {
    const lattice = box([0.4, 0.2, 0.2], { resolution: 4 });
    const { places, velocities } = lattice.masses;
    const rest = places.slice();
    shake(velocities, 1e-3);
    const start = moving(lattice.masses);
    const parts = lattice.parts(1) * share;
    for (let n = 0; n < 3000; n++) {
      lattice.push(1 / parts);
      for (let j = 0; j < places.length; j++) places[j]! += velocities[j]! / parts;
    }
    assert.ok(rest.every(Number.isFinite), 'rest');
    assert.equal(moving(lattice.masses) < 10 * start, holds, `${share} of the parts`);
  }
});

test('what is made softer follows in fewer parts, and says by how much', () => {
  const lattice = box([0.4, 0.2, 0.2], { resolution: 4, youngsModulus: 1e7 });
  const parts = lattice.parts(1 / 60);
  above(parts, 10);
  assert.equal(lattice.soften(parts, 1 / 60), 1, 'not at all');
  const share = lattice.soften(3, 1 / 60);
  close(share, (3 / parts) ** 2, 0.3 * (3 / parts) ** 2, 'share');
  const { places, velocities } = lattice.masses;
  shake(velocities, 0.01);
  const start = moving(lattice.masses);
  for (let n = 0; n < 3000; n++) {
    lattice.push(1 / 180);
    for (let j = 0; j < places.length; j++) places[j]! += velocities[j]! / 180;
  }
  below(moving(lattice.masses), 2 * start, 'energy');
});

test('it becomes stiffer and heavier at once, and wants parts accordingly', () => {
  const lattice = box([0.4, 0.2, 0.2], { resolution: 4 });
  const parts = lattice.parts(1);
  lattice.stiffen({ youngsModulus: 4 * E, poissonsRatio: 0.3 });
  close(lattice.parts(1), 2 * parts, 2, 'stiffer');
  lattice.masses.weigh(4 * lattice.masses.mass);
  lattice.masses.free();
  close(lattice.parts(1), parts, 2, 'heavier');
  lattice.stiffen({ youngsModulus: E, poissonsRatio: 0.3 });
  close(lattice.parts(1), parts / 2, 2, 'softer again');
});

test('what weighs nothing stays where it is', () => {
  const lattice = solid(boxMesh([1, 1, 1]), 0);
  assert.equal(lattice.parts(1 / 60), 1, 'parts');
  assert.equal(lattice.soften(1, 1 / 60), 1, 'softness');
  lattice.push(1 / 60);
  assert.ok(
    lattice.masses.velocities.every((v) => v === 0),
    'velocities',
  );
});
