/** Corners of triangles or lines, in numbers as wide as x3dom makes them. */
export const indexOf = (all: ArrayLike<number>, corners: number): Uint16Array | Uint32Array =>
  corners > 65535 ? Uint32Array.from(all) : Uint16Array.from(all);
