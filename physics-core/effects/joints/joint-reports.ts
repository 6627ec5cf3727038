import type { ReportedJoint } from '../effect/chunks.js';

/** With masses more unlike than this a chain whips faster than steps of `standard` follow (measured: 5 mm off in 1 s). */
const HARD_MASS_RATIO = 100;

export function reportBodies(joint: ReportedJoint): void {
  const { body1, body2, label } = joint;
  joint.reportWhile(!body1 && !body2, {
    code: 'no-body',
    severity: 'warning',
    used: 'nothing',
    message: `${label} names no body and holds nothing until body1 or body2 does`,
  });
  joint.reportWhile(body1 !== undefined && body1 === body2, {
    code: 'same-body',
    severity: 'warning',
    attribute: 'body2',
    used: 'nothing',
    message: `${label} names ${body1?.label} as body1 and as body2 and holds nothing until they differ`,
  });
}

export function reportMassRatio(joint: ReportedJoint): void {
  const { body1, body2, label } = joint;
  const masses = [body1, body2].map((body) => (body?.movable ? body.mass.mass : 0));
  const ratio = Math.max(...masses) / Math.min(...masses);
  joint.reportWhile(Number.isFinite(ratio) && ratio > HARD_MASS_RATIO, {
    code: 'mass-ratio',
    severity: 'warning',
    value: ratio,
    used: 'the present accuracy',
    message: `${label} holds ${body1?.label} (${masses[0]} kg) to ${body2?.label} (${masses[1]} kg): so unlike masses hold, but whip about faster than coarse steps follow: accuracy="fine" or better keeps their way true`,
  });
}
