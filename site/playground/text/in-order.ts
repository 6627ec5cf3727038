/** The places of a longest row of numbers that rise, as they stand in the list. */
export function inOrder(numbers: readonly number[]): number[] {
  /** For each place the longest row that ends there: its length, and the place before. */
  const length: number[] = [];
  const before: number[] = [];
  for (let i = 0; i < numbers.length; i++) {
    [length[i], before[i]] = [1, -1];
    for (let j = 0; j < i; j++) {
      if (numbers[j]! < numbers[i]! && length[j]! >= length[i]!) {
        [length[i], before[i]] = [length[j]! + 1, j];
      }
    }
  }
  const row: number[] = [];
  let at = length.indexOf(Math.max(...length));
  for (; at >= 0; at = before[at]!) row.unshift(at);
  return row;
}
