import { description } from '../node/common-fields.js';
import { contacts } from '../../effects/effect/chunks.js';
import { defineNode } from '../node/define.js';
import type { CollisionSensorNode } from './collision-sensor-node.js';

const watch = (sensor: CollisionSensorNode): void => sensor.updateWatch();

export const collisionSensor = defineNode<CollisionSensorNode>({
  name: 'CollisionSensor',
  containerField: 'children',
  clause: '37.4.5',
  doc: 'Tells whether members of a CollisionCollection touch.',
  rank: 5,
  chunk: contacts,
  fields: {
    ...description,
    collider: {
      type: 'SFNode',
      access: 'inputOutput',
      default: null,
      nodes: ['CollisionCollection'],
      edit: 'live',
      patch: watch,
      doc: 'The collection it watches; both members of a pair must be in it.',
    },
    enabled: {
      type: 'SFBool',
      access: 'inputOutput',
      default: true,
      edit: 'live',
      patch: watch,
      doc: 'FALSE: it sends nothing.',
    },
    isActive: {
      type: 'SFBool',
      access: 'outputOnly',
      default: false,
      edit: 'passive',
      read: (sensor) => sensor.isActive,
      doc: 'Whether anything touched in the last step.',
    },
    intersections: {
      type: 'MFNode',
      access: 'outputOnly',
      default: [],
      edit: 'passive',
      read: (sensor) => sensor.intersections,
      doc: 'The collidables that touch, each once.',
    },
    contacts: {
      type: 'MFNode',
      access: 'outputOnly',
      default: [],
      nodes: ['Contact'],
      edit: 'passive',
      read: (sensor) => sensor.contacts,
      doc: 'One Contact for each point where members touch, new with every step; made only where it is read or ROUTEd.',
    },
  },
});
