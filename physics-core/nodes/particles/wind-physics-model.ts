import { defineNode } from '../node/define.js';
import { changed, modelFields } from './model-fields.js';
import { WindModelNode } from './model-node.js';

export const windPhysicsModel = defineNode<WindModelNode>({
  name: 'WindPhysicsModel',
  containerField: 'physics',
  clause: '40.4.10',
  doc: 'A wind that pushes particles by their surfaceArea, and bodies by what it sees of them where its system pushes, in gusts.',
  rank: 4,
  make: (context) => new WindModelNode(context),
  fields: {
    ...modelFields,
    direction: {
      type: 'SFVec3f',
      access: 'inputOutput',
      default: [1, 0, 0],
      default3: [0, 0, 0],
      edit: 'live',
      patch: changed,
      doc: 'Where the wind blows, in the frame of the system, whatever its length; 0 0 0: each time elsewhere.',
    },
    speed: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 0.1,
      range: [0, Infinity],
      dimension: { length: 1 },
      edit: 'live',
      patch: changed,
      doc: 'Speed of the wind between gusts, m/s.',
    },
    gustiness: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 0.1,
      range: [0, Infinity],
      edit: 'live',
      patch: changed,
      doc: 'Greatest share of the speed by which that of a gust is more or less.',
    },
    turbulence: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 0,
      range: [0, 1],
      edit: 'live',
      patch: changed,
      doc: 'How far particles and bodies are pushed off the way of the wind, each another way: 0 not at all, 1 anywhere.',
    },
  },
});
