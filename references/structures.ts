// What stands: bodies as they are put upon each other, for the core's facts and the stability matrix.

import { cos, sin } from '../physics-core/base/exact/index.js';

type Fields = Record<string, unknown>;

const box = (...size: number[]) => ({ type: 'Box', size });

/** So many boxes upon each other, with edges of `size` metres; `more` says what each has beyond that. */
export const stack = (count: number, size = 1, more: (i: number) => Fields = () => ({})) =>
  Array.from({ length: count }, (_, i) => ({
    position: [0, size * (i + 0.5), 0],
    geometry: [box(size, size, size)],
    ...more(i),
  }));

/** A cube of six faces. */
const CORNERS = [
  [-1, -1, -1],
  [1, -1, -1],
  [1, 1, -1],
  [-1, 1, -1],
  [-1, -1, 1],
  [1, -1, 1],
  [1, 1, 1],
  [-1, 1, 1],
];
export const hullCube = {
  type: 'IndexedFaceSet',
  coord: CORNERS.flat().map((x) => x / 2),
  coordIndex: [
    0, 3, 2, 1, -1, 4, 5, 6, 7, -1, 0, 1, 5, 4, -1, 1, 2, 6, 5, -1, 2, 3, 7, 6, -1,
  ].concat([3, 0, 4, 7, -1]),
};

/** Rows of cubes, each with one less than the one below. */
export const pyramid = (rows: number): Fields[] =>
  Array.from({ length: rows }, (_, row) =>
    Array.from({ length: rows - row }, (_, k) => ({
      position: [(k - (rows - 1 - row) / 2) * 1.05, 0.5 + row, 0],
      geometry: [box(1, 1, 1)],
    })),
  ).flat();

/** Rows of bricks of 1 × .5 × .5 m in running bond, with half bricks at the ends of every other row; joints of `gap` metres. */
export const wall = (rows: number, columns: number, gap: number): Fields[] =>
  Array.from({ length: rows }, (_, row) => {
    const y = 0.25 + row * 0.5;
    const shift = row % 2 ? 0.5 : 0;
    const whole = Array.from({ length: columns - (row % 2) }, (_, k) => ({
      position: [(k + shift) * (1 + gap), y, 0],
      geometry: [box(1, 0.5, 0.5)],
    }));
    const half = [-0.25, (columns - 1) * (1 + gap) + 0.25].map((x) => ({
      position: [x, y, 0],
      mass: 0.5,
      geometry: [box(0.5 - gap, 0.5, 0.5)],
    }));
    return row % 2 ? [...whole, ...half] : whole;
  }).flat();

/** Cards of 1 m, 4 cm thick, that lean on each other in pairs: three pairs, two upon them, and one. */
export function cards(): Fields[] {
  const [long, thick, wide, lean] = [1, 0.04, 0.7, 0.35];
  const tall = long * cos(lean) + thick * sin(lean);
  const half = (long * sin(lean) + thick * cos(lean)) / 2;
  const pitch = 4 * half + 0.02;
  const leaning = (x: number, y: number, side: number) => ({
    position: [x + side * half, y + tall / 2, 0],
    orientation: [0, 0, 1, side * lean],
    mass: 0.1,
    geometry: [box(thick, long, wide)],
  });
  const lying = (x: number, y: number) => ({
    position: [x, y + tall + thick / 2, 0],
    mass: 0.1,
    geometry: [box(0.98 * pitch, thick, wide)],
  });
  return [0, 1, 2].flatMap((storey) => {
    const pairs = 3 - storey;
    const y = storey * (tall + thick);
    const place = (k: number) => (k - (pairs - 1) / 2) * pitch;
    return Array.from({ length: pairs }, (_, k) => [
      leaning(place(k), y, -1),
      leaning(place(k), y, 1),
      ...(k < pairs - 1 ? [lying(place(k + 0.5), y)] : []),
    ]).flat();
  });
}

/** A half ring of wedges, 2.4 m to 3 m from its middle. */
export function arch(wedges: number): Fields[] {
  const [inner, outer, deep] = [2.4, 3, 0.8];
  return Array.from({ length: wedges }, (_, i) => {
    const [begin, end] = [(Math.PI * i) / wedges, (Math.PI * (i + 1)) / wedges];
    const middle = (begin + end) / 2;
    const centre = [cos(middle), sin(middle)].map((u) => (u * (inner + outer)) / 2);
    const coord = [begin, end].flatMap((angle) =>
      [inner, outer].flatMap((radius) =>
        [-deep / 2, deep / 2].flatMap((z) => [
          radius * cos(angle) - centre[0]!,
          radius * sin(angle) - centre[1]!,
          z,
        ]),
      ),
    );
    const faces = [0, 2, 3, 1, -1, 4, 5, 7, 6, -1, 0, 1, 5, 4, -1, 2, 6, 7, 3, -1, 0, 4, 6, 2, -1];
    const coordIndex = [...faces, 1, 3, 7, 5, -1];
    return {
      position: [...centre, 0],
      geometry: [{ type: 'IndexedFaceSet', coord, coordIndex }],
    };
  });
}
