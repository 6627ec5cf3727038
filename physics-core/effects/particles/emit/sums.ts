/** Each of the sizes added to all before it. */
export function sumsOf(sizes: readonly number[]): Float64Array {
  let sum = 0;
  return Float64Array.from(sizes, (size) => (sum += size));
}

/** Which of the sizes holds a share, from 0 to below 1, of their sum: each as often as it is large. */
export function foundIn(sums: Float64Array, share: number): number {
  let low = 0;
  let high = sums.length - 1;
  const wanted = share * sums[high]!;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (sums[middle]! > wanted) high = middle;
    else low = middle + 1;
  }
  return low;
}
