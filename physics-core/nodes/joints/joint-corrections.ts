import { guards } from '../../base/guards.js';
import type { RowCorrection } from '../../dynamics/joint.js';
import { perStep, softnessAtStep } from '../../dynamics/levels.js';
import type { JointSettings } from '../node/node-world.js';

/** From 1 on Bullet lets a joint go altogether (measured: a sag of 500 m). */
const MOST_SOFTNESS = 0.9;

/** Error correction per 1/60 s, and softness (X3D's constantForceMix) where it is the joint's own. */
export type OwnCorrection = Pick<RowCorrection, 'erp'> & Partial<RowCorrection>;

/**
 * Share of a row's error repaired per step, and X3D's constantForceMix for steps of this length; `own`: where the row has
 * its own.
 */
export function correctionAt(
  { errorCorrection, constantForceMix, stepSeconds }: JointSettings,
  own: OwnCorrection | undefined,
): RowCorrection {
  return {
    erp: own ? perStep(own.erp, stepSeconds) : errorCorrection,
    softness:
      own?.softness === undefined
        ? constantForceMix
        : softnessAtStep(own.softness, own.erp, stepSeconds),
  };
}

/**
 * X3D's constantForceMix is velocity per force; Bullet 2.82 scales it by the row's own response, so it is divided by
 * dt · J M⁻¹ Jᵀ.
 */
export const softnessInBullet = (
  constantForceMix: number,
  response: number,
  stepSeconds: number,
): number =>
  guards.jointSoftness(constantForceMix / (stepSeconds * response || Infinity), MOST_SOFTNESS);
