import { joints } from '../../effects/effect/chunks.js';
import { defineNode } from '../node/define.js';
import { AttachmentNode } from './attachment-node.js';

const changed = (attachment: AttachmentNode): void => attachment.changed();

export const softBodyAttachment = defineNode<AttachmentNode>({
  name: 'SoftBodyAttachment',
  containerField: 'attachments',
  clause: '',
  doc: 'Ties a point of a rope, a cloth or a soft body to a body, or to a place in the world: each pulls the other.',
  rank: 5,
  chunk: joints,
  make: (context) => new AttachmentNode(context),
  fields: {
    softBody: {
      type: 'SFNode',
      access: 'inputOutput',
      default: null,
      nodes: ['Rope', 'Cloth', 'SoftBody'],
      own: true,
      edit: 'live',
      patch: changed,
      doc: 'The rope, the cloth or the soft body.',
    },
    index: {
      type: 'SFInt32',
      access: 'inputOutput',
      default: 0,
      range: [0, Infinity],
      own: true,
      edit: 'live',
      patch: changed,
      doc: 'Which of its points, counted from 0.',
    },
    body: {
      type: 'SFNode',
      access: 'inputOutput',
      default: null,
      nodes: ['RigidBody'],
      own: true,
      edit: 'live',
      patch: changed,
      doc: 'The body; NULL: the world.',
    },
    position: {
      type: 'SFVec3f',
      access: 'inputOutput',
      default: [0, 0, 0],
      dimension: { length: 1 },
      own: true,
      edit: 'live',
      patch: changed,
      doc: 'Where on the body, metres, in its frame; without a body in the world. The point is taken there.',
    },
  },
});
