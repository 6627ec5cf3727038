import type { NodeData } from '../conformance/fact.js';
import { use } from '../conformance/scenes.js';
import { OFF, SHARES, type Edit } from './edit.js';

/** Far from everything else: nothing touches it. */
const sheet = (y: number): NodeData => ({
  type: 'IndexedTriangleSet',
  index: [0, 1, 2, 1, 3, 2],
  coord: { type: 'Coordinate', point: [0, y, 0, 1, y, 0, 0, y, 1, 1, y, 1] },
});

/** It touches nothing where it has a size, and so is amid all others. */
export const clothScene = (): NodeData[] => [
  {
    type: 'Cloth',
    DEF: 'cloth',
    geometry: sheet(-700),
    thickness: 0,
    tearStrain: 10,
    shearStiffness: 1,
  },
];

export const clothSubjects = { Cloth: 'cloth' };

const edit = (values: Edit['values'], more: Partial<Edit> = {}): Edit => ({
  values,
  changes: ['?.positions'],
  stays: ['?.positions'],
  ...more,
});

export const clothEdits: Record<string, Edit> = {
  enabled: edit(OFF),
  geometry: edit([use('flat'), use('long')], {
    given: { size: [1, 1] },
    stays: ['.geometry', '?.positions'],
  }),
  size: edit([
    [1, 2],
    [2, 1],
  ]),
  subdivision: edit(
    [
      [2, 3],
      [3, 2],
    ],
    { given: { size: [1, 1] } },
  ),
  mass: edit(SHARES),
  thickness: edit([0.02, 0.03], { stays: ['.thickness', '?.positions'] }),
  stretchStiffness: edit([10, 20]),
  shearStiffness: edit(SHARES, { stays: ['.shearStiffness', '?.positions'] }),
  bendStiffness: edit([1e-3, 2e-3]),
  damping: edit(SHARES),
  friction: edit([0.2, 0.8]),
  fixedIndex: edit([[0], [1]]),
  selfCollision: edit([true, false]),
  tearStrain: edit([5, 6], { stays: ['.tearStrain', '?.positions'] }),
  wind: edit([
    [0, 0, 1],
    [1, 0, 0],
  ]),
};
