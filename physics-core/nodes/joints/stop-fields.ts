import type { JointNode } from './joint.js';
import type { Doc, Field } from '../node/table.js';

/** Stops this near to a full turn count as none: the angle itself jumps there from one end to the other. */
const NEARLY_PI = Math.PI - 1e-4;

export const nearlyWhole = (low: number, high: number): boolean =>
  low <= -NEARLY_PI && high >= NEARLY_PI;

type Patch<N> = (joint: N) => void;

/** A stop of an angle. */
export const angleStop = <N extends JointNode>(
  value: number,
  patch: Patch<N>,
  { doc }: Doc,
): Field<N> => ({
  type: 'SFFloat',
  access: 'inputOutput',
  default: value,
  range: [-Math.PI, Math.PI],
  dimension: { angle: 1 },
  edit: 'live',
  patch,
  doc,
});

/** A share between 0 and 1: of a rate that comes back, or of an overshoot that is repaired. */
const share = <N extends JointNode>(value: number, patch: Patch<N>, { doc }: Doc): Field<N> => ({
  type: 'SFFloat',
  access: 'inputOutput',
  default: value,
  range: [0, 1],
  edit: 'live',
  patch,
  doc,
});

export const bounceField = <N extends JointNode>(patch: Patch<N>, doc: Doc): Field<N> =>
  share(0, patch, doc);

export const correctionField = share;

/** Stop fields of a node that has no stops for them to act on. */
export const idleStop = (n: number, of: 'Bounce' | 'ErrorCorrection'): Field<JointNode> => ({
  type: 'SFFloat',
  access: 'inputOutput',
  default: of === 'Bounce' ? 0 : 0.8,
  range: [0, 1],
  edit: 'passive',
  doc: `Kept, and without effect: X3D gives this node no limits, so nothing stops about axis ${n}.`,
});
