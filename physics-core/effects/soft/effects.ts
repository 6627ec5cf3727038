import { Chunk } from '../../base/chunk.js';
import type { EffectDescriptor } from '../effect/effect.js';
import type { Ropes } from './ropes.js';

export const ropeChunk = new Chunk({ name: 'ropes', causes: 'a Rope' });

/** Ropes hang, swing, wind round bodies, and tie them. */
export const ropes: EffectDescriptor<Ropes> = {
  name: 'ropes',
  causes: 'a Rope',
  after: {
    forces: 'it reads what pushes its bodies in the step',
    suspension: 'the same',
    dragging: 'the same',
    particles: 'the same',
    water: 'the same',
    motors: 'the same',
    carrying: 'what is carried takes its ends along',
    'gyroscopic torque': 'it begins with the spin of free motion',
    'impact propagation': 'what was hit goes where its hits take it',
  },
  chunk: ropeChunk,
};
