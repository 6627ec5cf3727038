// The chunk `deformables`.
import { provideDeformableEffects } from '../../effects/deformable-code.js';
import { lateTypes } from '../../nodes/late.js';
import { deformableTypes } from '../../nodes/soft/deformable-types.js';

export function provide(): void {
  provideDeformableEffects();
  Object.assign(lateTypes, deformableTypes);
}
