import type { NodeData } from '../conformance/fact.js';
import { use } from '../conformance/scenes.js';
import { ON, POINTS, SHARES, type Edit } from './edit.js';

const block = (...size: number[]): NodeData => ({ type: 'Box', size });

export const SURFACE_SPARES: Record<string, NodeData> = {
  block: block(1, 1, 1),
  otherBlock: block(2, 1, 1),
};

/** They touch nothing and stand still; without its size a Cloth has its geometry. */
export const deformableScene = (type: string): NodeData[] => [
  type === 'Cloth'
    ? { type, DEF: 'cloth', geometry: block(3, 3, 3), size: [1, 1], enabled: false }
    : { type, DEF: 'softBody', geometry: block(3, 3, 3), enabled: false },
];

export const deformableSubjects = { Cloth: 'cloth', SoftBody: 'softBody' };

const edit = (values: Edit['values'], more: Partial<Edit> = {}): Edit => ({
  values,
  changes: ['?.positions'],
  stays: ['?.positions'],
  ...more,
});

const common: Record<string, Edit> = {
  enabled: edit(ON, { stays: ['.enabled', '?.positions'] }),
  mass: edit([2, 3]),
  damping: edit(SHARES),
  friction: edit([0.2, 0.8]),
  fixedIndex: edit([[0], [1]]),
  draggableBody: edit(ON),
};

export const clothEdits: Record<string, Edit> = {
  ...common,
  geometry: edit([use('block'), use('otherBlock')], { stays: ['.geometry', '?.positions'] }),
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
  geometry: edit([use('block'), use('otherBlock')], {
    stays: ['.geometry', '~built', '~effects', '?.positions'],
    vanishes: true,
    ends: ['bad-value'],
  }),
  youngsModulus: edit([2e4, 3e4]),
  poissonsRatio: edit([0.1, 0.2]),
  pressure: edit([1000, 2000]),
  thickness: edit([0.02, 0.03]),
};
