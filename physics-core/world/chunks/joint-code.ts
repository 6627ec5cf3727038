// The chunk `joints`.
import { provideJointEffects } from '../../effects/joint-code.js';
import { provideJoints } from '../../nodes/joints/classes.js';

export function provide(): void {
  provideJointEffects();
  provideJoints();
}
