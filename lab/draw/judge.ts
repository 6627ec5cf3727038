import { levels } from '../../physics-core/inside.js';
import { floorOf, type Case } from '../case.js';
import type { Row } from '../run/row.js';

// The lab's criteria, judged from its rows.

export const levelNames: readonly string[] = levels.map(({ name }) => name);

/** What came to no number is as wrong as can be. */
export const errorOf = ({ error }: Row): number => error ?? Infinity;

export const rowsOf = (which: Case, engine: string, rows: readonly Row[]): Row[] =>
  rows.filter((row) => row.case === which.id && row.engine === engine);

/** Our rows at the levels, coarse to fine. */
export const ladderOf = (which: Case, rows: readonly Row[]): Row[] =>
  levelNames.flatMap(
    (level) => rowsOf(which, 'ours', rows).find((row) => row.level === level) ?? [],
  );

/** Levels whose error is above that of the level before it, and not under the floor. */
export function brokenRungs(which: Case, rows: readonly Row[]): string[] {
  const ladder = ladderOf(which, rows);
  return ladder
    .filter((row, i) => i > 0 && errorOf(row) > Math.max(errorOf(ladder[i - 1]!), floorOf(which)))
    .map(({ level }) => level!);
}

/** Levels that cost no more than the level before. */
export function cheapRungs(which: Case, rows: readonly Row[]): string[] {
  const ladder = ladderOf(which, rows);
  return ladder.filter(({ ms }, i) => i > 0 && ms <= ladder[i - 1]!.ms).map(({ level }) => level!);
}

/** The runs that no cheaper run beats, cheapest first. */
export function frontierOf(rows: readonly Row[]): Row[] {
  const sorted = rows.toSorted((a, b) => a.ms - b.ms);
  return sorted.filter((row, i) =>
    sorted.slice(0, i).every((cheaper) => errorOf(cheaper) > errorOf(row)),
  );
}

/**
 * The least error that these runs reach in so much time: between two runs of the frontier on the straight line of the
 * logarithms. Who has no run so cheap is given the cheapest.
 */
export function errorAt(ms: number, rows: readonly Row[]): number {
  const frontier = frontierOf(rows).filter(({ error }) => error !== null);
  if (frontier.length === 0) return Infinity;
  const next = frontier.findIndex((row) => row.ms > ms);
  if (next === 0) return errorOf(frontier[0]!);
  if (next < 0) return errorOf(frontier.at(-1)!);
  const [a, b] = [frontier[next - 1]!, frontier[next]!];
  const share = Math.log(ms / a.ms) / Math.log(b.ms / a.ms);
  const [from, to] = [a, b].map((row) => Math.max(errorOf(row), Number.MIN_VALUE)) as [
    number,
    number,
  ];
  return from * (to / from) ** share;
}

/** Our `standard` beside the best that another engine reaches in the same time. */
export interface Duel {
  /** Milliseconds per simulated second of `standard`. */
  ms: number;
  ours: number;
  /** Null where the engine has no words for the case. */
  theirs: number | null;
  floor: number;
  /** How many times their error is ours; what is under the floor counts as at it. */
  factor: number | null;
}

export function duel(which: Case, engine: string, rows: readonly Row[]): Duel | undefined {
  const standard = ladderOf(which, rows).find(({ level }) => level === 'standard');
  if (!standard) return undefined;
  const [floor, ours] = [floorOf(which), errorOf(standard)];
  const others = rowsOf(which, engine, rows);
  if (others.length === 0) return { ms: standard.ms, ours, theirs: null, floor, factor: null };
  const theirs = errorAt(standard.ms, others);
  const factor = Math.max(theirs, floor) / Math.max(ours, floor);
  return { ms: standard.ms, ours, theirs, floor, factor };
}

/** By whom `standard` is judged. */
const RIVALS = ['ammo', 'rapier', 'jolt'];

/** Our `standard` beside the best that raw Ammo, Rapier and Jolt reach in the same time, and who that is. */
export function hardestDuel(
  which: Case,
  rows: readonly Row[],
): (Duel & { engine: string }) | undefined {
  const all = RIVALS.flatMap((engine) => {
    const one = duel(which, engine, rows);
    return one ? [{ ...one, engine }] : [];
  });
  return all.toSorted((a, b) => (a.theirs ?? Infinity) - (b.theirs ?? Infinity))[0];
}

/** Whether another is nearer to the truth, and we are not at our floor. */
export const isBehind = ({ ours, theirs, floor }: Duel): boolean =>
  theirs !== null && ours > floor && ours >= theirs;

/** Milliseconds per simulated second that the cheapest of these runs takes to reach an error. */
export function timeTo(error: number, rows: readonly Row[]): Row | undefined {
  return rows.filter((row) => errorOf(row) <= error).sort((a, b) => a.ms - b.ms)[0];
}

/** 10 cm, 1 cm, 1 mm and 0.1 mm; of what is no length, the same shares of its size, 1 m standing for it. */
export const goalsOf = ({ unit, size }: Case): number[] =>
  [0.1, 0.01, 0.001, 0.0001].map((goal) => (unit === 'm' ? goal : goal * size));
