import { Chunk } from '../../../physics-core/inside.js';
import { lowerName } from '../words/dom.js';

/** What reads tags of X3D's component of particle systems. */
export const particleTags = new Chunk({ name: 'particles', causes: 'a ParticleSystem' });
/** The same of water. */
export const waterTags = new Chunk({ name: 'water', causes: 'a WaterVolume' });
/** The same of ropes, and what ties them. */
export const ropeTags = new Chunk({ name: 'ropes', causes: 'a Rope' });
/** The same of cloth and soft bodies. */
export const deformableTags = new Chunk({ name: 'deformables', causes: 'a Cloth or a SoftBody' });

/** By how tags end. */
const LATE: readonly [ends: RegExp, code: Chunk][] = [
  [/(particle-?system|emitter|physics-?model)$/, particleTags],
  [/water-?volume$/, waterTags],
  [/(^|-)rope$|soft-?body-?attachment$/, ropeTags],
  [/(^|-)cloth$|soft-?body$/, deformableTags],
];

/** What has to come before somebody reads its tag. */
export const lateCode = (element: Element): Chunk | undefined =>
  LATE.find(([ends, { here }]) => !here && ends.test(lowerName(element)))?.[1];
