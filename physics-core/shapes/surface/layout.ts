// How numbers of a surface lie, for whoever looks at one: by themselves, as a surface comes with the code of meshes alone.

/** Numbers of a box: least x, y, z, greatest x, y, z. */
export const BOX = 6;

/** What is beyond a side of a triangle, as seen from where its normal points. */
export const SEAM = { rises: 1, flat: 0, falls: -1, nothing: -2 } as const;
