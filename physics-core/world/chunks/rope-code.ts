// The chunk `ropes`.
import { provideRopeEffects } from '../../effects/soft-code.js';
import { lateTypes } from '../../nodes/late.js';
import { softTypes } from '../../nodes/soft/index.js';

export function provide(): void {
  provideRopeEffects();
  Object.assign(lateTypes, softTypes);
}
