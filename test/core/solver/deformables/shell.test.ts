import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Shell } from '../../../../physics-core/solver/deformables/shell.js';
import { above, below, close } from '../../helpers.js';
import {
  ballMesh,
  boxMesh,
  fineBoxMesh,
  forces,
  momenta,
  moving,
  Run,
  turn,
  type Mesh,
  volumeOf,
} from './helpers.js';
import { shake } from './lattices.js';
import { E, RADIUS, shell, step, THICKNESS, within } from './shells.js';

// ---- a gas in it -------------------------------------------------------------------------------------------------------

test('its pressure times its volume stays: what is blown up wide has less', () => {
  const ball = shell(ballMesh(RADIUS, 2), { pressure: 500 });
  new Run(ball).settle(0.2);
  const grown = (within(ball) / volumeOf(ballMesh(RADIUS, 2).points, ballMesh(RADIUS, 2).index)) ** (1 / 3); // prettier-ignore
  above(grown, 1.03);
  // By the pressure that is left, and the stretch of its skin: Hooke's law is not far off at some percent.
  const expected = ((500 / grown ** 3) * RADIUS * grown * 0.6) / (2 * E * THICKNESS);
  close(grown - 1, expected, 0.1 * expected);
});

test('a surface that looks inward is blown up all the same', () => {
  const { points, index } = ballMesh(RADIUS, 2);
  const out = shell({ points, index });
  const inward = shell({ points, index: [...index].reverse() });
  for (const each of [out, inward]) new Run(each).settle(0.15);
  close(-within(inward), within(out), 1e-9);
  close(inward.volume, out.volume, 1e-12);
});

test('what is open, flat or nowhere holds no gas, and nothing comes of asking it', () => {
  const one = boxMesh([1, 1, 1]);
  const none: Record<string, Mesh> = {
    none: { points: [], index: [] },
    point: { points: [1, 2, 3], index: [0, 0, 0] },
    nowhere: { points: one.points.map(() => NaN), index: one.index },
    astray: { points: one.points, index: one.index.map((i) => i + 100) },
  };
  for (const [name, mesh] of Object.entries(none)) {
    const nothing = shell(mesh);
    assert.equal(nothing.masses.count, 0, name);
    assert.equal(nothing.parts(1 / 60), 1, name);
    assert.equal(nothing.soften(1, 1 / 60), 1, name);
    nothing.push(1 / 60);
    nothing.pressure = 10;
    nothing.stiffen({ youngsModulus: 1, poissonsRatio: 0, thickness: 1 });
  }
  for (const mesh of [boxMesh([1, 1, 0]), { points: one.points, index: one.index.slice(6) }]) {
    const open = shell(mesh, { pressure: 100 });
    above(open.masses.count, 3);
    assert.equal(open.volume, 0, 'volume');
    below(Math.max(...forces(open, (time) => open.push(time)).map(Math.abs)), 1e-12, 'forces');
  }
});

// ---- its skin ----------------------------------------------------------------------------------------------------------

test('points that are laid twice are one', () => {
  const box = shell(fineBoxMesh([1, 1, 1], 4));
  assert.equal(box.masses.count, 5 ** 3 - 3 ** 3, 'points');
  close(
    box.masses.masses.reduce((sum, m) => sum + m),
    3,
    1e-12,
    'mass',
  );
  close([...box.surface.places], fineBoxMesh([1, 1, 1], 4).points, 1e-12, 'surface');
  close(box.volume, 1, 1e-12, 'volume');
});

test('a point off by rounding alone is the same, too; and triangles without area are drawn, and no more', () => {
  const mesh = ballMesh(RADIUS, 2);
  const count = mesh.points.length / 3;
  mesh.points.push(...mesh.points.slice(0, 3).map((p) => p + 1e-9), 9, 9, 9);
  mesh.index = mesh.index.map((i, n) => (i === 0 && n % 2 ? count : i));
  mesh.index.push(0, 1, 1);
  const ball = shell(mesh);
  assert.equal(ball.masses.count, count, 'points');
  above(ball.volume, 0.4);
  assert.ok(ball.surface.places.every(Number.isFinite), 'surface');
});

test('a strip that is pulled is longer by the pull over its stiffness', () => {
  const points: number[] = [];
  const index: number[] = [];
  for (let i = 0; i <= 20; i++) for (let j = 0; j <= 4; j++) points.push(i / 20, j / 20, 0);
  for (let i = 0; i < 20; i++)
    for (let j = 0; j < 4; j++) {
      const a = 5 * i + j;
      index.push(a, a + 5, a + 6, a, a + 6, a + 1);
    }
  const strip = shell({ points, index });
  const { velocities, inverse } = strip.masses;
  const pull = 1;
  const run = new Run(strip, () => {
    for (const i of run.at(0, 0)) velocities[3 * i] = 0;
  });
  const [first, last] = [run.at(1, 0), run.at(1, 0.2)];
  strip.push = (time) => {
    Shell.prototype.push.call(strip, time);
    for (const i of run.at(0, 1)) {
      const share = first.includes(i) || last.includes(i) ? 1 / 8 : 1 / 4;
      velocities[3 * i]! += time * pull * share * inverse[i]!;
    }
  };
  run.settle(4 * Math.sqrt(15 / (E * THICKNESS)));
  const longer = pull / (E * THICKNESS * 0.2);
  close(run.gone(run.at(0, 1), 0), longer, 0.01 * longer);
  // And narrower by Poisson's ratio of that.
  const narrower = run.gone(first, 1) - run.gone(last, 1);
  close(narrower, 0.4 * longer * 0.2, 0.03 * longer * 0.2);
});

test('what is only turned has no forces but those of its gas, and all turn nothing', () => {
  const ball = shell(ballMesh(RADIUS, 2), { pressure: 50 });
  const { places } = ball.masses;
  const push = (time: number): void => ball.push(time);
  const before = forces(ball, push);
  turn(places, 1);
  const turned = forces(ball, push);
  turn(before, 1);
  close([...turned], [...before], 1e-12);
  shake(places, 0.1);
  const acting = forces(ball, push);
  const all = acting.reduce((sum, f) => sum + Math.abs(f), 0);
  for (let k = 0; k < 3; k++) {
    let sum = 0;
    let torque = 0;
    const l = (k + 1) % 3;
    const m = (k + 2) % 3;
    for (let i = 0; i < places.length; i += 3) {
      sum += acting[i + k]!;
      torque += places[i + l]! * acting[i + m]! - places[i + m]! * acting[i + l]!;
    }
    below(Math.abs(sum), 1e-12 * all, 'sum');
    below(Math.abs(torque), 1e-12 * all, 'torque');
  }
});

test('what tumbles and trembles keeps its momenta', () => {
  const ball = shell(ballMesh(RADIUS, 2), { pressure: 50 });
  const { velocities } = ball.masses;
  const run = new Run(ball);
  for (let i = 0; i < velocities.length; i += 3) {
    velocities[i] = 1 - 2 * run.rest[i + 1]!;
    velocities[i + 1] = 2 * run.rest[i]!;
  }
  shake(velocities, 0.3);
  const first = momenta(ball.masses);
  run.go(3);
  const last = momenta(ball.masses);
  close(last.along, first.along, 1e-10, 'momentum');
  close(last.about, first.about, 1e-10, 'angular momentum');
});

// ---- parts -------------------------------------------------------------------------------------------------------------

test('so many parts as it says are enough, and half of them too few', () => {
  for (const [share, holds] of [
    [1, true],
    [0.5, false],
  ] as const) {
    const ball = shell(ballMesh(RADIUS, 2), { pressure: 0 });
    const { places, velocities } = ball.masses;
    shake(velocities, 1e-3);
    const start = moving(ball.masses);
    const parts = ball.parts(1) * share;
    for (let n = 0; n < 3000; n++) {
      ball.push(1 / parts);
      for (let j = 0; j < places.length; j++) places[j]! += velocities[j]! / parts;
    }
    assert.equal(moving(ball.masses) < 10 * start, holds, `${share} of the parts`);
  }
});

test('what is made softer follows in fewer parts, keeps its shape, and is as it was once there are enough', () => {
  const ball = shell(ballMesh(RADIUS, 2), { pressure: 50 });
  const laid = within(ball);
  const parts = ball.parts(1 / 60);
  assert.equal(ball.soften(parts, 1 / 60), 1, 'not at all');
  const share = ball.soften(2, 1 / 60);
  above(share, (2 / (parts + 1)) ** 2, 'share');
  below(share, 3 * (2 / parts) ** 2, 'share');
  const { places, velocities } = ball.masses;
  shake(velocities, 0.1);
  for (let n = 0; n < 3000; n++) {
    ball.soften(2, 1 / 60);
    ball.push(1 / 120);
    for (let j = 0; j < places.length; j++) {
      velocities[j]! /= 1 + 1 / 120;
      places[j]! += velocities[j]! / 120;
    }
  }
  close(within(ball), laid, 0.1 * laid);
  assert.equal(ball.soften(10 * parts, 1 / 60), 1, 'as it was');
});

test('it becomes stiffer, heavier and fuller at once', () => {
  const ball = shell(ballMesh(RADIUS, 2));
  const parts = ball.parts(1);
  ball.stiffen({ youngsModulus: 4 * E, poissonsRatio: 0.4, thickness: THICKNESS });
  close(ball.parts(1), 2 * parts, 0.01 * parts, 'stiffer');
  ball.masses.weigh(4 * ball.masses.mass);
  ball.masses.free();
  close(ball.parts(1), parts, 0.01 * parts, 'heavier');
  ball.pressure = 1e6;
  above(ball.parts(1), 1.2 * parts, 'fuller');
});

test('a sliver makes nothing soft but itself', () => {
  const mesh = ballMesh(RADIUS, 2);
  // A point right beside another one, on a side that two triangles share.
  const [a, b, c] = mesh.index.slice(0, 3) as [number, number, number];
  const other = mesh.index.findIndex(
    (i, n) => i === b && mesh.index[n % 3 === 2 ? n - 2 : n + 1] === a,
  );
  const d = mesh.index[other - (other % 3) + ((other + 2) % 3)]!;
  const near = mesh.points.length / 3;
  for (let k = 0; k < 3; k++)
    mesh.points.push(
      mesh.points[3 * a + k]! + 0.01 * (mesh.points[3 * b + k]! - mesh.points[3 * a + k]!),
    );
  const first = other - (other % 3);
  mesh.index.splice(first, 3, b, near, d, near, a, d);
  mesh.index.splice(0, 3, a, near, c, near, b, c);
  const ball = shell(mesh);
  above(ball.volume, 0.4, 'closed');
  const plain = shell(ballMesh(RADIUS, 2)).parts(1 / 60);
  above(ball.parts(1 / 60), 2 * plain, 'parts');
  above(ball.soften(2 * plain, 1 / 60), 0.97, 'share');
  const { places, velocities } = ball.masses;
  shake(velocities, 0.01);
  const start = moving(ball.masses);
  const h = 1 / 60 / (2 * plain);
  for (let n = 0; n < 3000; n++) {
    ball.push(h);
    for (let j = 0; j < places.length; j++) places[j]! += h * velocities[j]!;
  }
  below(moving(ball.masses), 10 * start);
});

test('what weighs nothing stays where it is', () => {
  const ball = shell(ballMesh(RADIUS, 2), { mass: 0 });
  const { places } = ball.masses;
  const rest = places.slice();
  step(ball, 3, 0, 10);
  close([...places], [...rest], 0);
});
