/** Neighbours that may have come to stand before something smaller, until that is taken to be what is out of place. */
const FEW = 8;

/**
 * Sorts the first `count` of numbers that are all different and mostly in order, as a list is of which some were taken out
 * by the last coming in their place, and to which some were added: what is out of place is sorted by itself, and merged.
 * `room` has at least as many.
 */
export function sortNearly(numbers: Float64Array, count: number, room: Float64Array): void {
  let kept = 0;
  let left = 0;
  for (let i = 0; i < count; i++) {
    const number = numbers[i]!;
    const before = placeOf(number, numbers, kept);
    if (before < 0) room[left++] = number;
    else {
      while (kept > before) room[left++] = numbers[--kept]!;
      numbers[kept++] = number;
    }
  }
  if (left === 0) return;
  room.subarray(0, left).sort();
  for (let to = count - 1; left > 0; to--) {
    const isKept = kept > 0 && numbers[kept - 1]! > room[left - 1]!;
    numbers[to] = isKept ? numbers[--kept]! : room[--left]!;
  }
}

/** How many of those that are in order stay before a number; -1: it is itself out of place. */
function placeOf(number: number, numbers: Float64Array, kept: number): number {
  let before = kept;
  while (before > 0 && numbers[before - 1]! > number) {
    if (kept - before === FEW) return -1;
    before--;
  }
  return before;
}
