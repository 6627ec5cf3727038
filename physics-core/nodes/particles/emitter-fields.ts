import { LEAST_MASS } from '../../fields/bounds.js';
import type { Field } from '../node/table.js';
import type { EmitterNode } from './emitter-node.js';

type EmitterFields = Record<string, Field<EmitterNode>>;

export const changed = (emitter: EmitterNode): void => emitter.changed();

/** Fields of X3DParticleEmitterNode (40.3.1). */
export const emitterFields: EmitterFields = {
  on: {
    type: 'SFBool',
    access: 'inputOutput',
    default: true,
    edit: 'live',
    patch: changed,
    doc: 'FALSE: no particle is born, and those that there are live on.',
  },
  speed: {
    type: 'SFFloat',
    access: 'inputOutput',
    default: 0,
    range: [0, Infinity],
    dimension: { length: 1 },
    edit: 'live',
    patch: changed,
    doc: 'Speed that particles are born with, m/s.',
  },
  variation: {
    type: 'SFFloat',
    access: 'inputOutput',
    default: 0.25,
    range: [0, Infinity],
    edit: 'live',
    patch: changed,
    doc: 'Greatest share of the speed by which that of a particle is more or less, evenly spread; none is below 0.',
  },
  mass: {
    type: 'SFFloat',
    access: 'inputOutput',
    default: 0,
    range: [0, Infinity],
    least: LEAST_MASS,
    dimension: { mass: 1 },
    edit: 'live',
    patch: changed,
    doc: 'Mass of each particle, kilograms; with 0 no force and no wind moves it.',
  },
  surfaceArea: {
    type: 'SFFloat',
    access: 'inputOutput',
    default: 0,
    range: [0, Infinity],
    dimension: { length: 2 },
    edit: 'live',
    patch: changed,
    doc: 'Area that each particle shows to the wind, m².',
  },
};

/** Of those that emit from one point. */
export const positionField: EmitterFields = {
  position: {
    type: 'SFVec3f',
    access: 'inputOutput',
    default: [0, 0, 0],
    dimension: { length: 1 },
    edit: 'live',
    patch: changed,
    doc: 'Where particles are born, metres, in the frame of their system.',
  },
};

/** Of those that emit one way. */
export const directionField: EmitterFields = {
  direction: {
    type: 'SFVec3f',
    access: 'inputOutput',
    default: [0, 1, 0],
    edit: 'live',
    patch: changed,
    doc: 'Where particles go at first, in the frame of their system, whatever its length; 0 0 0 sends each another way.',
  },
};
