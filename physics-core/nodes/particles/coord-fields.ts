import type { Doc, Field } from '../node/table.js';
import type { CoordEmitterNode } from './coord-emitter-node.js';
import { changed } from './emitter-fields.js';

/**
 * Of emitters that have points; `doc`: of coordIndex. The standard has an initializeOnly coordIndex, and set_coordIndex for
 * events: here both are one field, so that what events said is kept as all else is.
 */
export const coordFields = ({ doc }: Doc): Record<string, Field<CoordEmitterNode>> => ({
  coord: {
    type: 'SFNode',
    access: 'inputOutput',
    default: null,
    // A mesh of points alone is kept in its place: plain data that is looked through as all geometry is.
    nodes: ['Coordinate', 'Mesh'],
    edit: 'live',
    patch: changed,
    doc: 'Its points, metres, in the frame of the system: a Coordinate, or the flat list of its numbers.',
  },
  coordIndex: {
    type: 'MFInt32',
    access: 'inputOutput',
    default: [-1],
    range: [-1, Infinity],
    edit: 'live',
    patch: changed,
    doc,
  },
});
