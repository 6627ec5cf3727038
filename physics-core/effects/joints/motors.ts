import type { Joint } from '../../dynamics/joint.js';
import { Effect, type EffectDescriptor } from '../effect/effect.js';

/** Torques and forces between the bodies of joints. Motors that heed a rate are rows of the joint solve. */
export class Motors extends Effect {
  override beforeStep(dt: number): void {
    for (const node of this.causes) (node as Joint).push(dt);
  }
}

export const motors: EffectDescriptor<Motors> = {
  name: 'motors',
  causes: 'a torque, force or motor of a joint',
  joint({ attached, drivenBy, motors: heeding }) {
    if (!attached) return undefined;
    return drivenBy ?? (heeding.length > 0 ? 'maxTorque1, maxTorque2' : undefined);
  },
  load: () => new Motors(),
};
