import type { JointNode } from './joint.js';

/** With masses more unlike than this a chain whips faster than steps of `standard` follow (measured: 5 mm off in 1 s). */
const HARD_MASS_RATIO = 100;

export function reportBodies(joint: JointNode): void {
  reportNobody(joint);
  reportSameBody(joint);
}

function reportSameBody(joint: JointNode): void {
  if (!joint.body1 || joint.body1 !== joint.body2) {
    joint.world.settle(joint, 'body2', 'same-body');
    return;
  }
  joint.report({
    code: 'same-body',
    severity: 'warning',
    attribute: 'body2',
    used: 'nothing',
    message: `${joint.label} names ${joint.body1.label} as body1 and as body2 and holds nothing until they differ`,
  });
}

function reportNobody(joint: JointNode): void {
  if (joint.body1 || joint.body2) {
    joint.world.settle(joint, undefined, 'no-body');
    return;
  }
  joint.report({
    code: 'no-body',
    severity: 'warning',
    used: 'nothing',
    message: `${joint.label} names no body and holds nothing until body1 or body2 does`,
  });
}

export function reportMassRatio(joint: JointNode): void {
  const masses = [joint.body1, joint.body2].map((body) => (body?.movable ? body.mass.mass : 0));
  const ratio = Math.max(...masses) / Math.min(...masses);
  if (!Number.isFinite(ratio) || ratio <= HARD_MASS_RATIO) {
    joint.world.settle(joint, undefined, 'mass-ratio');
    return;
  }
  joint.report({
    code: 'mass-ratio',
    severity: 'warning',
    value: ratio,
    used: 'the present accuracy',
    message: `${joint.label} holds ${joint.body1!.label} (${masses[0]} kg) to ${joint.body2!.label} (${masses[1]} kg): so unlike masses hold, but whip about faster than coarse steps follow: accuracy="fine" or better keeps their way true`,
  });
}
