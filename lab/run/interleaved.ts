import { median } from './median.js';

/** Calls that one side takes before the next has its turn: short, so that the machine's mood hits all alike. */
const TURN = 10;

/** Milliseconds per call of each side, which take turns; `first` begins. Medians of turns: another process takes some. */
export function interleaved<Name extends string>(
  sides: Readonly<Record<Name, () => void>>,
  calls: number,
  first: number,
): Record<Name, number> {
  const names = Object.keys(sides) as Name[];
  const turns = names.map((): number[] => []);
  for (let turn = 0; turn < calls / TURN; turn++)
    for (let i = 0; i < names.length; i++) {
      const at = (i + first + turn) % names.length;
      const side = sides[names[at]!];
      const start = performance.now();
      for (let call = 0; call < TURN; call++) side();
      turns[at]!.push((performance.now() - start) / TURN);
    }
  return Object.fromEntries(names.map((name, i) => [name, median(turns[i]!)])) as Record<
    Name,
    number
  >;
}
