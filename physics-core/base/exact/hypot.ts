/** The root of a sum of squares: the largest is taken out, and what each sum rounds off is given to the next (Kahan). */
export function lengthOf(values: ArrayLike<number>): number {
  let most = 0;
  for (let i = 0; i < values.length; i++) most = Math.max(most, Math.abs(values[i]!));
  if (most === 0 || most === Infinity) return most;
  let sum = 0;
  let over = 0;
  for (let i = 0; i < values.length; i++) {
    const share = values[i]! / most;
    const next = share * share - over;
    const now = sum + next;
    over = now - sum - next;
    sum = now;
  }
  return Math.sqrt(sum) * most;
}

/** Of two or three, without an array: both are what steps ask for most. */
export function hypot(x: number, y: number, z?: number): number {
  const two = Math.max(Math.abs(x), Math.abs(y));
  const most = z === undefined ? two : Math.max(two, Math.abs(z));
  if (most === 0 || most === Infinity) return most;
  const a = x / most;
  const b = y / most;
  const first = a * a;
  const next = b * b;
  const sum = first + next;
  if (z === undefined) return Math.sqrt(sum) * most;
  const over = sum - first - next;
  const c = z / most;
  return Math.sqrt(sum + (c * c - over)) * most;
}
