import { defineNode } from '../node/define.js';
import type { Doc, Field } from '../node/table.js';
import { RopeNode } from './rope-node.js';
import { draggableBody, softNeeds } from './soft-node.js';

const changed = (rope: RopeNode): void => rope.changed();

const number = (
  value: number,
  { doc }: Doc,
  also: Partial<Field<RopeNode>> = {},
): Field<RopeNode> => ({
  type: 'SFFloat',
  access: 'inputOutput',
  default: value,
  range: [0, Infinity],
  own: true,
  edit: 'live',
  patch: changed,
  doc,
  ...also,
});

export const rope = defineNode<RopeNode>({
  name: 'Rope',
  containerField: 'softBodies',
  clause: '',
  doc: 'A rope: it only pulls, hangs and swings, lies on bodies and winds round them, and ties what is attached to it.',
  rank: 4,
  needs: softNeeds,
  make: (context) => new RopeNode(context),
  bounded: true,
  fields: {
    enabled: {
      type: 'SFBool',
      access: 'inputOutput',
      default: true,
      own: true,
      edit: 'live',
      patch: changed,
      doc: 'FALSE: it stands still, and holds nothing.',
    },
    geometry: {
      type: 'SFNode',
      access: 'inputOutput',
      default: null,
      nodes: ['LineSet', 'IndexedLineSet', 'Mesh'],
      own: true,
      edit: 'rebuild',
      doc: 'A LineSet or an IndexedLineSet: its first line is the rope as it is laid.',
    },
    points: {
      type: 'MFVec3f',
      access: 'inputOutput',
      default: [],
      dimension: { length: 1 },
      own: true,
      edit: 'rebuild',
      doc: 'The line along which it is laid, metres; it wins over geometry. An edit lays it anew.',
    },
    segments: {
      type: 'SFInt32',
      access: 'inputOutput',
      default: 0,
      range: [0, 10000],
      own: true,
      edit: 'rebuild',
      doc: 'How many links of one length it is divided into; 0: as many as its line has.',
    },
    mass: number(1, { doc: 'kg, of the whole rope.' }, { open: true, dimension: { mass: 1 } }),
    radius: number(
      0.01,
      { doc: 'Half of its thickness, metres; 0: it touches nothing.' },
      { dimension: { length: 1 } },
    ),
    stretchStiffness: number(
      0,
      {
        doc: 'Newtons that would stretch it to twice its length, if it went on as it begins; 0: it does not stretch.',
      },
      { dimension: { force: 1 } },
    ),
    bendStiffness: number(0, {
      doc: 'What it takes to bend it, N m²: E I of a beam; 0: it bends freely. More than a step follows is told (soft-too-stiff).',
    }),
    damping: number(0, { doc: 'Share of its speed that it loses, 1/s.' }),
    friction: number(0.5, { doc: 'Coulomb friction on what it touches.' }),
    selfCollision: {
      type: 'SFBool',
      access: 'inputOutput',
      default: false,
      own: true,
      edit: 'live',
      patch: changed,
      doc: 'TRUE: its links do not go through each other. It costs, so it is off.',
    },
    fixedIndex: {
      type: 'MFInt32',
      access: 'inputOutput',
      default: [],
      range: [0, Infinity],
      own: true,
      edit: 'live',
      patch: changed,
      doc: 'Points that stay where they are, counted from 0.',
    },
    draggableBody,
    positions: {
      type: 'MFVec3f',
      access: 'outputOnly',
      default: [],
      // X3D's nodes of points say `coord_changed`.
      aliases: ['coord'],
      dimension: { length: 1 },
      own: true,
      edit: 'passive',
      read: (node) => node.positions,
      doc: 'Where its points are, metres.',
    },
  },
});
