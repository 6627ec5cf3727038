import type { NodeData } from '../conformance/fact.js';
import { use } from '../conformance/scenes.js';
import { OFF, ON, POINTS, SHARES, type Edit } from './edit.js';

const line = (...point: number[]): NodeData => ({
  type: 'LineSet',
  vertexCount: [point.length / 3],
  coord: { type: 'Coordinate', point },
});

export const LINE_SPARES: Record<string, NodeData> = {
  line: line(0, -500, 0, 1, -500, 0, 1, -501, 0),
  otherLine: line(0, -500, 0, 0, -500, 1, 0, -501, 1),
};

/** Far from everything else: nothing touches it. Without its points it has a line, and the other way round. */
export const ropeScene = (): NodeData[] => [
  {
    type: 'Rope',
    DEF: 'rope',
    points: [0, -500, 0, 1, -500, 0, 2, -500, 0],
    geometry: line(0, -500, 0, 0, -500, 1, 0, -500, 3),
  },
  { type: 'Rope', DEF: 'otherRope', points: [0, -600, 0, 1, -600, 0, 2, -600, 0] },
  { type: 'SoftBodyAttachment', DEF: 'tie', softBody: use('rope'), position: [0, -500, 0] },
];

export const ropeSubjects = { Rope: 'rope', SoftBodyAttachment: 'tie' };

const edit = (values: Edit['values'], more: Partial<Edit> = {}): Edit => ({
  values,
  changes: ['?.positions'],
  stays: ['?.positions'],
  ...more,
});

export const ropeEdits: Record<string, Edit> = {
  enabled: edit(OFF),
  geometry: edit([use('line'), use('otherLine')], {
    stays: ['.geometry', '?.positions'],
  }),
  points: edit(
    [
      [
        [0, -500, 0],
        [1, -500, 0],
        [3, -500, 0],
      ],
      [
        [0, -500, 0],
        [0, -500, 1],
        [0, -500, 2],
      ],
    ],
    { stays: ['.points', '?.positions'] },
  ),
  segments: edit([4, 8]),
  draggableBody: edit(ON),
  mass: edit(SHARES),
  radius: edit([0.02, 0.03]),
  stretchStiffness: edit([1000, 2000]),
  bendStiffness: edit(SHARES),
  damping: edit(SHARES),
  friction: edit([0.2, 0.8]),
  selfCollision: edit(ON),
  fixedIndex: edit([[0], [1]]),
};

export const attachmentEdits: Record<string, Edit> = {
  softBody: { values: [use('otherRope'), use('rope')], stays: ['.softBody'] },
  index: { values: [1, 2] },
  body: { values: [use('spare'), use('pole')] },
  position: { values: POINTS, stays: ['.position'] },
};
