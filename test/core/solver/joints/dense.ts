import assert from 'node:assert/strict';
import { Forest, type Edge } from '../../../../physics-core/solver/joints/forest.js';
import { RowSystem } from '../../../../physics-core/solver/joints/row-system.js';
import { random } from '../../helpers.js';

export const SIDE = 6;
export const ROWS = 8;
export const INERTIA = 7;
export const BLOCK = ROWS * SIDE;

/** The same system as full matrices. */
export interface Dense {
  /** Inertia of all bodies, rows of all joints, momenta, targetVelocity rates, compliances. */
  m: number[][];
  j: number[][];
  p: number[];
  targetVelocity: number[];
  soft: number[];
  /** Where row i of `j` is in the system. */
  at: number[];
}

/** Rows that close loops give way by a millionth of what they would do alone; here that comes to 2.8e-5 at most. */
export const GIVE = 4e-5;

export const next = random(7);
export const between = (low: number, high: number): number => low + (high - low) * next();

export function made(bodies: number, edges: Edge[], system = new RowSystem()): RowSystem {
  const forest = new Forest();
  forest.build(bodies, edges);
  system.resize(bodies, edges, forest);
  return system;
}

/** Positive definite inertia and random momenta. */
export function fillBodies(system: RowSystem, bodies: number, { m, p }: Dense): void {
  for (let b = 0; b < bodies; b++) {
    const [mass, t] = [between(0.1, 5), Array.from({ length: 9 }, () => between(-1, 1))];
    system.inertia[b * INERTIA] = mass;
    for (let r = 0; r < SIDE; r++) {
      for (let c = 0; c < SIDE; c++) {
        let value = r === c ? (r < 3 ? mass : 0.5) : 0;
        if (r > 2 && c > 2)
          for (let k = 0; k < 3; k++) value += t[(r - 3) * 3 + k]! * t[(c - 3) * 3 + k]!;
        m[b * SIDE + r]![b * SIDE + c] = value;
        if (r > 2 && c > 2 && c <= r)
          system.inertia[b * INERTIA + 1 + ((r - 3) * (r - 2)) / 2 + c - 3] = value;
      }
      p[b * SIDE + r] = system.momentum[b * SIDE + r] = between(-3, 3);
    }
  }
}

export function fillRow(
  system: RowSystem,
  joint: number,
  r: number,
  dense: Dense,
  soft: number,
): void {
  const { a, b } = system.edges[joint]!;
  const row: number[] = new Array<number>(dense.p.length).fill(0);
  for (let x = 0; x < SIDE; x++) {
    const at = joint * 2 * BLOCK + r * SIDE + x;
    const [one, two] = [between(-1, 1), between(-1, 1)];
    // Rows at a pin are about axes.
    const pinned = system.isPin[joint] === 1;
    system.jacobian[at] = pinned && x < 3 ? 0 : one;
    system.jacobian[at + BLOCK] = pinned ? -system.jacobian[at]! : two;
    if (a >= 0) row[a * SIDE + x] = system.jacobian[at]!;
    if (b >= 0) row[b * SIDE + x] = system.jacobian[at + BLOCK]!;
  }
  const i = joint * ROWS + r;
  system.targetVelocity[i] = system.threshold[i] = between(-1, 1);
  system.compliance[i] = soft;
  system.unbounded(i);
  dense.j.push(row);
  dense.targetVelocity.push(system.targetVelocity[i]!);
  dense.soft.push(soft);
  dense.at.push(i);
}

export function filled(
  system: RowSystem,
  bodies: number,
  rows: (joint: number) => number,
  soft = 0,
): Dense {
  const n = bodies * SIDE;
  const m = Array.from({ length: n }, () => new Array<number>(n).fill(0));
  const dense: Dense = { m, j: [], p: [], targetVelocity: [], soft: [], at: [] };
  fillBodies(system, bodies, dense);
  system.edges.forEach(({ rows: besides }, joint) => {
    if (system.isPin[joint] && !besides) return;
    system.rowCount[joint] = rows(joint);
    for (let r = 0; r < rows(joint); r++) fillRow(system, joint, r, dense, soft);
  });
  return dense;
}

/** M v - Jᵀ λ = p, J v + γ λ = targetVelocity: by Gauss with pivots. Returns v and λ. */
export function solved({ m, j, p, targetVelocity, soft }: Dense): number[] {
  const [n, size] = [p.length, p.length + j.length];
  const k = Array.from({ length: size }, () => new Array<number>(size + 1).fill(0));
  m.forEach((row, i) => {
    row.forEach((value, c) => (k[i]![c] = value));
    k[i]![size] = p[i]!;
  });
  j.forEach((row, r) => {
    row.forEach((value, i) => {
      k[n + r]![i] = value;
      k[i]![n + r] = -value;
    });
    k[n + r]![n + r] = soft[r]!;
    k[n + r]![size] = targetVelocity[r]!;
  });
  for (let i = 0; i < size; i++) {
    let pivot = i;
    for (let r = i; r < size; r++) if (Math.abs(k[r]![i]!) > Math.abs(k[pivot]![i]!)) pivot = r;
    [k[i], k[pivot]] = [k[pivot]!, k[i]!];
    for (let r = 0; r < size; r++) {
      const factor = k[r]![i]! / k[i]![i]!;
      if (r !== i) for (let c = i; c <= size; c++) k[r]![c]! -= factor * k[i]![c]!;
    }
  }
  return k.map((row, i) => row[size]! / row[i]!);
}

export function solveAll(system: RowSystem): void {
  for (const component of system.forest.components) assert.ok(system.solve(component));
}

/** Widest difference from the dense solution, velocities and impulses of rows. */
export function difference(system: RowSystem, dense: Dense): number {
  const expected = solved(dense);
  const n = dense.p.length;
  return expected.reduce((worst, value, i) => {
    if (i >= n + dense.at.length) return worst;
    const actual = i < n ? system.velocity[i]! : system.impulse[dense.at[i - n]!]!;
    return Math.max(worst, Math.abs(actual - value) / (1 + Math.abs(value)));
  }, 0);
}

export const chain = (n: number): Edge[] =>
  Array.from({ length: n }, (_, i) => ({ a: i - 1, b: i }));

export const star = (n: number): Edge[] => chain(n).map(({ b }) => ({ a: b, b: b ? 0 : -1 }));

export const tree = (n: number): Edge[] =>
  chain(n).map(({ b }) => ({ a: Math.floor((b - 1) / 2), b }));
