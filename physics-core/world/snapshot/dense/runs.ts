/** Whole numbers that mostly go on evenly, as plain data: of each run its first, the step, and how many. */
export function runsOf(numbers: Iterable<number>): number[] {
  const runs: number[] = [];
  let [last, step, at] = [NaN, NaN, -3];
  for (const number of numbers) {
    if (runs[at + 2] === 1) runs[at + 1] = step = number - last;
    if (number === last + step) runs[at + 2]!++;
    else {
      at = runs.push(number, 0, 1) - 3;
      step = NaN;
    }
    last = number;
  }
  return runs;
}

export function inRuns(runs: readonly number[]): number[] {
  const numbers: number[] = [];
  for (let at = 0; at < runs.length; at += 3)
    for (let i = 0; i < runs[at + 2]!; i++) numbers.push(runs[at]! + i * runs[at + 1]!);
  return numbers;
}
