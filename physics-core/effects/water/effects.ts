import { Chunk } from '../../base/chunk.js';
import type { EffectDescriptor } from '../effect/effect.js';
import type { MovingSurfaces } from './moving-surface.js';
import type { Simulation } from '../../dynamics/simulation.js';
import type { Swimming } from './swimming.js';
import type { Water } from './water.js';

export const waters = new Chunk({ name: 'water', causes: 'a WaterVolume' });

export const waveChunk = new Chunk({ name: 'waves', causes: 'a WaterVolume whose waves are TRUE' });

/** What water does to all that gives way. */
export interface SwimmingCode {
  swimming(simulation: Simulation): Swimming;
}

export const swimming = new Chunk<SwimmingCode>({
  name: 'swimming',
  causes: 'a Rope, a Cloth or a SoftBody in a world that has a WaterVolume',
});

/** The surface of water moves. */
export const waves: EffectDescriptor<MovingSurfaces> = {
  name: 'waves',
  causes: waveChunk.causes,
  chunk: waveChunk,
};

/** Bodies float in water, and are braked by it. */
export const water: EffectDescriptor<Water> = {
  name: 'water',
  causes: 'a WaterVolume',
  after: {
    carrying: 'what is carried stirs it on its way',
    waves: 'what is pushed rides on the surface as it is by then',
  },
  chunk: waters,
};
