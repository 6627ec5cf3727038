// The chunk `impacts`.
import { reportGiven, reportOneSided } from '../../effects/contacts/collection-reports.js';
import type { ImpactCode } from '../../effects/effect/chunks.js';
import { provideImpactEffects } from '../../effects/impact-code.js';
import { provideCollisionNodes } from '../../nodes/collision/classes.js';

export function provide(): ImpactCode {
  provideImpactEffects();
  provideCollisionNodes();
  return { reportGiven, reportOneSided };
}
