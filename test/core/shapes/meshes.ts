/** Corners and outward faces of a box, as an IndexedFaceSet. */
export const faces = (x: number, y: number, z: number) => ({
  type: 'IndexedFaceSet',
  coord: [0, 1, 2, 3, 4, 5, 6, 7].flatMap((i) => [
    (i & 1 ? x : -x) / 2,
    (i & 2 ? y : -y) / 2,
    (i & 4 ? z : -z) / 2,
  ]),
  coordIndex: [
    0, 2, 3, 1, -1, 4, 5, 7, 6, -1, 0, 1, 5, 4, -1, 2, 6, 7, 3, -1, 0, 4, 6, 2, -1, 1, 3, 7, 5, -1,
  ],
});

export const triangulated = (x: number, y: number, z: number): number[] => {
  const { coordIndex } = faces(x, y, z);
  const index: number[] = [];
  for (let i = 0; i < coordIndex.length; i += 5) {
    const [a, b, c, d] = coordIndex.slice(i, i + 4) as [number, number, number, number];
    index.push(a, b, c, a, c, d);
  }
  return index;
};

export const indexedTriangles = (x: number, y: number, z: number) => ({
  type: 'IndexedTriangleSet',
  coord: faces(x, y, z).coord,
  index: triangulated(x, y, z),
});

export const triangles = (x: number, y: number, z: number) => ({
  type: 'TriangleSet',
  coord: {
    point: triangulated(x, y, z).flatMap((i) => faces(x, y, z).coord.slice(i * 3, i * 3 + 3)),
  },
});
