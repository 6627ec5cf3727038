import type { NodeData } from '../conformance/fact.js';
import { use } from '../conformance/scenes.js';
import { OFF, ON, POINTS, SHARES, type Edit } from './edit.js';

const triangles = (index: number[], ...point: number[]): NodeData => ({
  type: 'IndexedTriangleSet',
  index,
  coord: { type: 'Coordinate', point },
});

const SQUARE = [0, 1, 2, 0, 2, 3];
const CLOSED = [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3];

export const SURFACE_SPARES: Record<string, NodeData> = {
  square: triangles(SQUARE, 0, -700, 0, 1, -700, 0, 1, -701, 0, 0, -701, 0),
  otherSquare: triangles(SQUARE, 0, -700, 0, 2, -700, 0, 2, -702, 0, 0, -702, 0),
  block: { type: 'Box', size: [1, 1, 1] },
  otherBlock: { type: 'Box', size: [2, 1, 1] },
};

/** Far from everything else: nothing touches it. Without its size a Cloth has its triangles. */
export const deformableScene = (type: string): NodeData[] =>
  type === 'Cloth'
    ? [
        {
          type: 'Cloth',
          DEF: 'cloth',
          size: [1, 1],
          geometry: triangles(SQUARE, 0, -700, 0, 1, -700, 0, 1, -700, 1, 0, -700, 1),
        },
      ]
    : [
        {
          type: 'SoftBody',
          DEF: 'softBody',
          geometry: triangles(CLOSED, 0, -800, 0, 1, -800, 0, 0, -799, 0, 0, -800, 1),
        },
      ];

export const deformableSubjects = { Cloth: 'cloth', SoftBody: 'softBody' };

const edit = (values: Edit['values'], more: Partial<Edit> = {}): Edit => ({
  values,
  changes: ['?.positions'],
  stays: ['?.positions'],
  ...more,
});

const common: Record<string, Edit> = {
  enabled: edit(OFF),
  mass: edit([2, 3]),
  damping: edit(SHARES),
  friction: edit([0.2, 0.8]),
  fixedIndex: edit([[0], [1]]),
};

export const clothEdits: Record<string, Edit> = {
  ...common,
  geometry: edit([use('square'), use('otherSquare')], { stays: ['.geometry', '?.positions'] }),
  size: edit(
    [
      [1, 2],
      [2, 1],
    ],
    { stays: ['.size', '?.positions'] },
  ),
  subdivision: edit([
    [4, 4],
    [2, 3],
  ]),
  thickness: edit([0.02, 0.03]),
  stretchStiffness: edit([100, 200]),
  shearStiffness: edit([1, 2]),
  bendStiffness: edit([0.001, 0.002]),
  selfCollision: edit(ON),
  tearStrain: edit([0.5, 0.8]),
  wind: edit(POINTS),
};

export const softBodyEdits: Record<string, Edit> = {
  ...common,
  geometry: edit([use('block'), use('otherBlock')], { stays: ['.geometry', '?.positions'] }),
  youngsModulus: edit([2e4, 3e4]),
  poissonsRatio: edit([0.1, 0.2]),
  pressure: edit([1000, 2000]),
  thickness: edit([0.02, 0.03]),
};
