import type { Chunk } from '../../base/chunk.js';
import { geometryTypes } from '../../shapes/geometry.js';
import type { Doc, Field } from '../node/table.js';
import { codeOf } from '../particles/mesh.js';
import type { DeformableNode } from './deformable-node.js';
import { draggableBody, softNeeds } from './soft-node.js';

const changed = (node: DeformableNode): void => node.changed();

export const deformableNumber = (
  value: number,
  { doc }: Doc,
  also: Partial<Field<DeformableNode>> = {},
): Field<DeformableNode> => ({
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

/** Code that both wait for. */
export const deformableNeeds = (node: DeformableNode): (Chunk<unknown> | undefined)[] => [
  ...codeOf(node.asked('geometry')),
  ...softNeeds(node),
];

/** What Cloth and SoftBody have in common. */
export const deformableFields: Record<string, Field<DeformableNode>> = {
  enabled: {
    type: 'SFBool',
    access: 'inputOutput',
    default: true,
    own: true,
    edit: 'live',
    patch: changed,
    doc: 'FALSE: it stands still, touches nothing and holds nothing.',
  },
  geometry: {
    type: 'SFNode',
    access: 'inputOutput',
    default: null,
    nodes: [...geometryTypes],
    own: true,
    edit: 'rebuild',
    doc: 'Its surface as it is laid: an IndexedTriangleSet, an IndexedFaceSet, or any other geometry by its triangles.',
  },
  mass: deformableNumber(1, { doc: 'kg, of all of it.' }, { open: true, dimension: { mass: 1 } }),
  damping: deformableNumber(0, { doc: 'Share of its speed that it loses, 1/s.' }),
  friction: deformableNumber(0.5, { doc: 'Coulomb friction on what it touches.' }),
  fixedIndex: {
    type: 'MFInt32',
    access: 'inputOutput',
    default: [],
    range: [0, Infinity],
    own: true,
    edit: 'live',
    patch: changed,
    doc: 'Points of its geometry that stay where they are, counted from 0.',
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
    doc: 'Where the points of its geometry are, metres.',
  },
};
