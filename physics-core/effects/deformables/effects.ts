import { Chunk } from '../../base/chunk.js';
import type { EffectDescriptor } from '../effect/effect.js';
import type { Deformables } from './deformables.js';

export const deformableChunk = new Chunk({
  name: 'deformables',
  causes: 'a Cloth or a SoftBody',
});

/** Cloth and soft bodies give way, hang, lie on bodies and push them. */
export const deformables: EffectDescriptor<Deformables> = {
  name: 'deformables',
  causes: 'a Cloth or a SoftBody',
  after: {
    forces: 'it reads what pushes the bodies that it touches',
    suspension: 'the same',
    dragging: 'the same',
    particles: 'the same',
    water: 'the same',
    motors: 'the same',
    carrying: 'what is carried takes along what is tied to it',
    'gyroscopic torque': 'it begins with the spin of free motion',
    'impact propagation': 'what was hit goes where its hits take it',
    ropes: 'the same',
  },
  chunk: deformableChunk,
};
