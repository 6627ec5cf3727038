import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Edge } from '../../../../physics-core/solver/joints/forest.js';
import { RowSystem } from '../../../../physics-core/solver/joints/row-system.js';
import { below } from '../../helpers.js';
import {
  SIDE,
  ROWS,
  GIVE,
  INERTIA,
  BLOCK,
  type Dense,
  between,
  made,
  filled,
  solved,
  solveAll,
  difference,
  chain,
  star,
  tree,
} from './dense.js';

/** A pin: the child's point against the parent's, as three rows of full matrices. */
function fillPin(system: RowSystem, pin: number, dense: Dense): void {
  const { pins, forest, edges } = system;
  const { arms } = pins.factors;
  const child = forest.jointOf.indexOf(pin);
  const parent = forest.parentOf[child]!;
  assert.ok([edges[pin]!.a, edges[pin]!.b].includes(child));
  for (let i = 0; i < 6; i++) arms[pin * 6 + i] = between(-1, 1);
  for (let x = 0; x < 3; x++) {
    const row: number[] = new Array<number>(dense.p.length).fill(0);
    for (const [body, at, sign] of [
      [child, 0, 1],
      [parent, 3, -1],
    ] as const) {
      if (body < 0) continue;
      const arm = arms.subarray(pin * 6 + at);
      row[body * SIDE + x] = sign;
      // (ω × r) along x.
      row[body * SIDE + 3 + ((x + 1) % 3)] = sign * arm[(x + 2) % 3]!;
      row[body * SIDE + 3 + ((x + 2) % 3)] = -sign * arm[(x + 1) % 3]!;
    }
    dense.j.push(row);
    dense.soft.push(0);
    dense.targetVelocity.push((pins.targetVelocity[pin * 3 + x] = between(-1, 1)));
  }
}

const graphs: Record<string, [number, Edge[]]> = {
  chain: [12, chain(12)],
  'chain that floats': [8, chain(8).slice(1)],
  star: [9, star(9)],
  tree: [15, tree(15)],
  'tree held at a leaf': [9, [...tree(9).slice(1), { a: 8, b: -1 }]],
  'three parts': [
    7,
    [
      { a: 0, b: 1 },
      { a: 1, b: 2 },
      { a: -1, b: 3 },
      { a: 4, b: 3 },
      { a: 6, b: 5 },
    ],
  ],
  ring: [6, [...chain(6).slice(1), { a: 5, b: 0 }]],
  'chain held at both ends': [5, [...chain(5), { a: 4, b: -1 }]],
  'two loops that share a side': [6, [...chain(6), { a: 0, b: 3 }, { a: 2, b: 5 }]],
  'two joints between the same bodies': [3, [...chain(3), { a: 2, b: 1 }]],
};

for (const [name, [bodies, edges]] of Object.entries(graphs)) {
  for (const soft of [0, 0.1]) {
    void test(`${name}, compliance ${soft}: velocities and impulses are those of the dense system`, () => {
      // Few enough rows that loops are not closed more than once.
      const system = made(bodies, edges);
      const dense = filled(system, bodies, (joint) => 2 + (joint % 2), soft);
      solveAll(system);
      const loops = system.forest.components.some((component) => component.loops.length > 0);
      below(difference(system, dense), loops ? GIVE : 1e-6, 'of the value');
    });
  }
}

/** Which joints are pins, and which of these have rows about axes besides. */
const pinnings: Record<string, (i: number) => Partial<Edge>> = {
  'all of its joints pins': () => ({ pin: true }),
  'half of its joints pins': (i) => ({ pin: i % 2 === 0 }),
  'all of its joints pins with rows': () => ({ pin: true, rows: true }),
  'pins with rows and without, and rows alone': (i) => ({ pin: i % 3 > 0, rows: i % 3 > 1 }),
};

for (const [name, [bodies, edges]] of Object.entries(graphs)) {
  for (const [pinning, pinned] of Object.entries(pinnings)) {
    void test(`${name}, ${pinning}: velocities and pulls are those of the dense system`, () => {
      const system = made(
        bodies,
        edges.map((edge, i) => ({ ...edge, ...pinned(i) })),
      );
      const dense = filled(system, bodies, (joint) => 1 + (joint % 2), 0.1);
      const pins = system.forest.components.flatMap((component) => [...component.pins]);
      // Where loops are closed, all joints are rows.
      const loops = system.forest.components.some((component) => component.loops.length > 0);
      assert.equal(pins.length > 0, !loops);
      for (const pin of pins) fillPin(system, pin, dense);
      solveAll(system);
      below(difference(system, dense), loops ? GIVE : 1e-6, 'of the value');
      const expected = solved(dense);
      const first = expected.length - 3 * pins.length;
      const pull = new Float64Array(3);
      pins.forEach((pin, i) => {
        const parent = system.forest.parentOf[system.forest.jointOf.indexOf(pin)]!;
        system.pins.pull(pin, system.velocity, parent, pull, 0, 1);
        for (let x = 0; x < 3; x++)
          below(Math.abs(pull[x]! - expected[first + 3 * i + x]!), 1e-6, 'N·s');
      });
    });
  }
}

void test('a loop closed more than once is solved as far as its rows agree', () => {
  // Each joint twice: the second says what the first does.
  const edges = chain(4).flatMap((edge) => [edge, edge]);
  const system = made(4, edges);
  filled(system, 4, () => 3);
  const single = made(4, chain(4));
  const dense = filled(single, 4, () => 3);
  single.inertia.forEach((value, i) => (system.inertia[i] = value));
  single.momentum.forEach((value, i) => (system.momentum[i] = value));
  for (let joint = 0; joint < 8; joint++) {
    const from = (joint >> 1) * 2 * BLOCK;
    system.jacobian.set(single.jacobian.subarray(from, from + 2 * BLOCK), joint * 2 * BLOCK);
    for (let r = 0; r < 3; r++)
      system.targetVelocity[joint * ROWS + r] = single.targetVelocity[(joint >> 1) * ROWS + r]!;
  }
  solveAll(system);
  const expected = solved(dense);
  for (let i = 0; i < 24; i++) below(Math.abs(system.velocity[i]! - expected[i]!), GIVE, 'm/s');
});

void test('bounded rows hold within their bounds, or stand at one and give way to its side', () => {
  for (const [bodies, edges] of Object.values(graphs)) {
    const system = made(bodies, edges);
    const dense = filled(system, bodies, () => 3, 1e-3);
    const bounded = dense.at.filter((_, i) => i % 3 === 0);
    bounded.forEach((row, i) => {
      const [least, most] = [
        [0, Infinity],
        [-Infinity, 0],
        [-0.2, 0.2],
      ][i % 3]!;
      system.bounded(row, least!, most!);
    });
    solveAll(system);
    for (const row of bounded) {
      const rate = system.rate(Math.floor(row / ROWS), row % ROWS);
      const impulse = system.impulse[row]!;
      const lacking = system.targetVelocity[row]! - rate - system.compliance[row]! * impulse;
      const [least, most] = [system.least[row]!, system.most[row]!];
      assert.ok(impulse > least - 1e-9 && impulse < most + 1e-9, `impulse ${impulse}`);
      // Lacking rate asks for more impulse: only where there is no more.
      if (lacking > GIVE) below(Math.abs(impulse - most), 1e-9, 'N·s from the upper bound');
      if (lacking < -GIVE) below(Math.abs(impulse - least), 1e-9, 'N·s from the lower bound');
    }
    const free = dense.at.filter((row) => !bounded.includes(row));
    for (const row of free) {
      const rate = system.rate(Math.floor(row / ROWS), row % ROWS);
      const expected = system.targetVelocity[row]! - system.compliance[row]! * system.impulse[row]!;
      below(Math.abs(rate - expected), GIVE, 'm/s');
    }
  }
});

void test('with other targetVelocity rates the factors stand', () => {
  const system = made(5, graphs['chain held at both ends']![1]);
  const dense = filled(system, 5, () => 3);
  solveAll(system);
  dense.at.forEach(
    (row, i) => (dense.targetVelocity[i] = system.targetVelocity[row]! += between(-1, 1)),
  );
  for (const component of system.forest.components) assert.ok(system.again(component));
  below(difference(system, dense), GIVE, 'of the value');
});

void test('a part solved again after another with loops has its own factors', () => {
  const edges = [...chain(4), { a: 3, b: -1 }].flatMap(({ a, b }) => [
    { a, b },
    { a: a < 0 ? -1 : a + 4, b: b < 0 ? -1 : b + 4 },
  ]);
  const system = made(8, edges);
  const dense = filled(system, 8, () => 3);
  solveAll(system);
  assert.equal(system.forest.components.length, 2);
  for (const component of system.forest.components) assert.ok(system.again(component));
  below(difference(system, dense), GIVE, 'of the value');
});

void test('inertia that is none has no solution', () => {
  for (const none of [NaN, -1, 0]) {
    const system = made(3, chain(3));
    filled(system, 3, () => 3);
    // Of the last body, which no other loads.
    system.inertia[2 * INERTIA] = none;
    assert.equal(system.solve(system.forest.components[0]!), false);
  }
});

void test('forty joints that hold one body are solved as far as they agree', () => {
  const edges = Array.from({ length: 40 }, () => ({ a: -1, b: 0 }));
  const system = made(1, edges);
  filled(system, 1, () => 3);
  assert.equal(system.solve(system.forest.components[0]!), true);
  assert.ok(system.velocity.subarray(0, SIDE).every(Number.isFinite));
});
