/** Numbers of a velocity: linear and angular. */
export const SIDE = 6;
/** Rows a joint may have: the six of a 6-DoF, and two motors on rows that have stops. */
export const ROWS = 8;
/** Numbers of a body's inertia: its mass, and what resists turning about its centre of mass as a triangle. */
export const INERTIA = 7;
/** Triangles of a body, and of the rows of a joint; the rows of a joint as one body sees them. */
export const BODY_BLOCK = (SIDE * (SIDE + 1)) / 2;
export const JOINT_BLOCK = (ROWS * (ROWS + 1)) / 2;
export const ROW_BLOCK = ROWS * SIDE;

/** Dot product of six numbers each. */
export function dot6(a: Float64Array, i: number, b: Float64Array, j: number): number {
  return (
    a[i]! * b[j]! +
    a[i + 1]! * b[j + 1]! +
    a[i + 2]! * b[j + 2]! +
    a[i + 3]! * b[j + 3]! +
    a[i + 4]! * b[j + 4]! +
    a[i + 5]! * b[j + 5]!
  );
}

/** `to` += s × `from`, six numbers. */
export function add6(to: Float64Array, i: number, from: Float64Array, j: number, s: number): void {
  to[i]! += s * from[j]!;
  to[i + 1]! += s * from[j + 1]!;
  to[i + 2]! += s * from[j + 2]!;
  to[i + 3]! += s * from[j + 3]!;
  to[i + 4]! += s * from[j + 4]!;
  to[i + 5]! += s * from[j + 5]!;
}

/** `to` = `from`, six numbers. */
export function copy6(to: Float64Array, i: number, from: Float64Array, j: number): void {
  to[i] = from[j]!;
  to[i + 1] = from[j + 1]!;
  to[i + 2] = from[j + 2]!;
  to[i + 3] = from[j + 3]!;
  to[i + 4] = from[j + 4]!;
  to[i + 5] = from[j + 5]!;
}

/** H ← H + A Bᵀ, with rows of six numbers: of A from `a` to `end`, of B from `b` to `last`. */
export function addProducts(
  h: Float64Array,
  to: number,
  rows: Float64Array,
  a: number,
  end: number,
  b: number,
  last: number,
): void {
  for (; a < end; a += SIDE) {
    const u = rows[a]!;
    const v = rows[a + 1]!;
    const w = rows[a + 2]!;
    const x = rows[a + 3]!;
    const y = rows[a + 4]!;
    const z = rows[a + 5]!;
    for (let c = b; c < last; c += SIDE)
      h[to++]! +=
        u * rows[c]! +
        v * rows[c + 1]! +
        w * rows[c + 2]! +
        x * rows[c + 3]! +
        y * rows[c + 4]! +
        z * rows[c + 5]!;
  }
}
