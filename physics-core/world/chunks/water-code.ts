// The chunk `water`.
import { provideWaterEffects } from '../../effects/water-code.js';
import { lateTypes } from '../../nodes/late.js';
import { waterTypes } from '../../nodes/water/index.js';

export function provide(): void {
  provideWaterEffects();
  Object.assign(lateTypes, waterTypes);
}
