import { test } from 'node:test';
import { SIDE } from '../../../../physics-core/solver/joints/blocks.js';
import { JoinedBodies } from '../../../../physics-core/solver/ropes/joined-bodies.js';
import { Links } from '../../../../physics-core/solver/ropes/links.js';
import { RopeSolve } from '../../../../physics-core/solver/ropes/rope-solve.js';
import { RopeSweeps } from '../../../../physics-core/solver/ropes/rope-sweeps.js';
import { FREE, HELD, Strand } from '../../../../physics-core/solver/ropes/strand.js';
import { TiedBodies } from '../../../../physics-core/solver/ropes/tied-bodies.js';
import { above, below } from '../../helpers.js';

const DT = 1 / 120;
const G = 9.8;
const POINTS = 9;
const MASSES = [3, 0.2, 1];
const BLOCK = SIDE * SIDE;

/** A strand of 1 m and .1 kg from one holder to another, as a step begins; its ends at arms of 10 cm. */
function strandOf(first: number, last: number, y: number): Strand {
  const strand = new Strand(POINTS);
  strand.lay(Array.from({ length: POINTS }, (_, i) => [i / 8, y - (i % 2) / 100, 0]).flat(), 0.1);
  strand.holders.fill(FREE);
  strand.holders[0] = first;
  strand.holders[POINTS - 1] = last;
  for (const [i, x] of [
    [0, 0.1],
    [POINTS - 1, -0.1],
  ] as const) {
    strand.arms[3 * i] = strand.armsBefore[3 * i] = x;
    strand.arms[3 * i + 1] = strand.armsBefore[3 * i + 1] = 0.05;
  }
  strand.begin(DT);
  for (let j = 1; j < 3 * POINTS; j += 3)
    strand.free[j] = strand.holders[(j - 1) / 3] === HELD ? 0 : -G * DT;
  return strand;
}

const strands = (): Strand[] => [strandOf(HELD, 0, 0), strandOf(0, 1, 0), strandOf(1, 2, 0)];

/** What bodies of those masses do by themselves, the last one thrown; with `joined`, some of them by what joints say of that. */
function fill(bodies: TiedBodies, joined: readonly JoinedBodies[]): void {
  MASSES.forEach((mass, b) => {
    for (let k = 0; k < SIDE; k++) {
      const inertia = k < 3 ? mass : mass / 100;
      const v = k === 1 ? -G * DT : k === 0 && b === 2 ? 1 : 0;
      bodies.inertias[BLOCK * b + (SIDE + 1) * k] = inertia;
      bodies.momenta[SIDE * b + k] = inertia * v;
      bodies.velocities[SIDE * b + k] = 0;
    }
  });
  for (const each of joined) {
    each.active = true;
    for (let r = 0; r < each.width; r++) {
      const b = each.first + Math.floor(r / SIDE);
      const inertia = bodies.inertias[BLOCK * b + (SIDE + 1) * (r % SIDE)]!;
      each.compliance[(each.width + 1) * r] = 1 / inertia;
      each.free[r] = bodies.momenta[each.from + r]! / inertia;
    }
  }
}

const search = (joined: readonly JoinedBodies[]): RopeSolve => {
  const solve = new RopeSolve();
  solve.take(strands(), MASSES.length, joined);
  fill(solve.bodies, joined);
  solve.solve(DT);
  return solve;
};

const isSame = (one: Float64Array, two: Float64Array, count: number, what: string): void => {
  let size = 0;
  for (let n = 0; n < count; n++) size = Math.max(size, Math.abs(one[n]!));
  above(size, 0, what);
  for (let n = 0; n < count; n++) below(Math.abs(one[n]! - two[n]!) / size, 1e-7, `${what} ${n}`);
};

for (const [what, joined] of [
  ['each by itself', () => [0, 1, 2].map((b) => new JoinedBodies(b, 1))],
  ['the first of them', () => [new JoinedBodies(0, 1)]],
  ['the last of them', () => [new JoinedBodies(2, 1)]],
] as const)
  test(`joints that hold nothing change nothing: ${what}`, () => {
    const [plain, other] = [search([]), search(joined())];
    isSame(plain.bodies.velocities, other.bodies.velocities, SIDE * 3, 'velocity');
    isSame(plain.impulse, other.impulse, SIDE * 3, 'impulse');
    isSame(plain.resistance, other.resistance, BLOCK * 3, 'resistance');
  });

test('nor do they where links are solved one at a time', () => {
  const [plain, other] = [[], [new JoinedBodies(0, 2)]].map((joined) => {
    const bodies = new TiedBodies();
    bodies.resize(MASSES.length, joined);
    fill(bodies, joined);
    const sweeps = new RopeSweeps(bodies);
    sweeps.begin([]);
    const links = strands().map((strand) => new Links(strand));
    for (const each of links) each.begin(DT);
    sweeps.solve(links, DT);
    return bodies;
  });
  isSame(plain!.velocities, other!.velocities, SIDE * 3, 'velocity');
});

test('two that joints make one go as one, and one that is held fast stays', () => {
  const one = new JoinedBodies(0, 2);
  const held = new JoinedBodies(2, 1);
  const solve = new RopeSolve();
  solve.take(strands(), MASSES.length, [one, held]);
  fill(solve.bodies, [one, held]);
  held.compliance.fill(0);
  held.free.fill(0);
  // Of both, 50 kg; neither turns.
  one.compliance.fill(0);
  for (let k = 0; k < 3; k++)
    for (const [r, c] of [
      [k, k],
      [k, SIDE + k],
      [SIDE + k, k],
      [SIDE + k, SIDE + k],
    ] as const)
      one.compliance[one.width * r + c] = 1 / 50;
  solve.solve(DT);
  const { velocities } = solve.bodies;
  for (let k = 0; k < SIDE; k++) {
    below(Math.abs(velocities[k]! - velocities[SIDE + k]!), 1e-12, 'one');
    below(Math.abs(velocities[2 * SIDE + k]!), 1e-15, 'held');
  }
  let given = 0;
  for (let b = 0; b < 2; b++) given += solve.impulse[SIDE * b]!;
  below(Math.abs(given / 50 - velocities[0]!), 1e-12, 'given');
});
