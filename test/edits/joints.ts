import { use } from '../conformance/scenes.js';
import { ANGLES, AXES, kept, ON, POINTS, SHARES, type Edit } from './edit.js';

/** The joint is made anew: its zero is now, so that what it answers and whom it holds begin there. */
const anew = (
  values: Edit['values'],
  outputs: readonly string[],
  more: readonly string[] = [],
): Edit => {
  const changes = ['~object', '~frames', ...outputs, ...more];
  return { values, changes, stays: changes };
};

/** The scene has a value of its own. */
const authored = (name: string, edit: Edit): Edit => ({
  ...edit,
  stays: [`.${name}`, ...(edit.stays ?? [])],
});

const anchorPoint = (outputs: readonly string[]): Edit =>
  authored('anchorPoint', anew(POINTS, outputs));

const BODIES = [use('spare'), use('pole')] as const;

/** `place`: outputs that any remake changes; `rates`: those that other bodies change. */
const jointEdits = (place: readonly string[], rates: readonly string[]): Record<string, Edit> => ({
  body1: authored('body1', anew(BODIES, [...place, ...rates], ['~bodies'])),
  body2: authored('body2', anew(BODIES, [...place, ...rates], ['~bodies'])),
  forceOutput: kept([['ALL'], ['NONE', 'ALL']]),
});

const ANCHORS = ['.body1AnchorPoint', '.body2AnchorPoint'];
const DIRECTIONS = ['.body1Axis', '.body2Axis'];

const stop = (given: Edit['given'] = {}): Pick<Record<string, Edit>, string> => ({
  stopBounce: { values: SHARES, given, changes: ['~stops'] },
  stopErrorCorrection: { values: SHARES, given, changes: ['~stops', '~corrections'] },
});

const hingeRates = ['.hinge1AngleRate', '.hinge2AngleRate'];
const STEERS = { minAngle1: -1, maxAngle1: 1 };

const motorRates = ['.motor1AngleRate', '.motor2AngleRate', '.motor3AngleRate'];

const motorEdits = (n: number): Record<string, Edit> => ({
  [`motor${n}Axis`]: anew(AXES, []),
  [`axis${n}Angle`]: { ...kept(ANGLES, [`.motor${n}Angle`]), tells: ['idle-motor'] },
  [`axis${n}Torque`]: { values: [2, 3], given: { enabledAxes: 3 }, changes: ['~effects'] },
  [`stop${n}Bounce`]: kept(SHARES),
  [`stop${n}ErrorCorrection`]: kept(SHARES),
});

/** Of two arms on one joint, which swing. */
export const edits: Record<string, Record<string, Edit>> = {
  BallJoint: { ...jointEdits(ANCHORS, []), anchorPoint: anchorPoint(ANCHORS) },
  SingleAxisHingeJoint: {
    ...jointEdits(ANCHORS, ['.angleRate']),
    anchorPoint: anchorPoint(ANCHORS),
    axis: anew(AXES, ANCHORS),
    minAngle: { values: [-0.5, -0.7], changes: ['~stops', '~limits', '~effects'] },
    maxAngle: { values: ANGLES, changes: ['~stops', '~limits', '~effects'] },
    ...stop({ minAngle: -1, maxAngle: 1 }),
  },
  DoubleAxisHingeJoint: {
    ...jointEdits([...ANCHORS, ...DIRECTIONS], hingeRates),
    anchorPoint: anchorPoint([...ANCHORS, ...DIRECTIONS]),
    axis1: anew(AXES, [...ANCHORS, ...DIRECTIONS]),
    axis2: anew(AXES, [...ANCHORS, ...DIRECTIONS], ['~limits']),
    minAngle1: { values: [-0.5, -0.7], changes: ['~stops', '~effects'] },
    maxAngle1: { values: ANGLES, changes: ['~stops', '~effects'] },
    stop1Bounce: { values: SHARES, given: STEERS, changes: ['~stops'] },
    stop1ErrorCorrection: { values: SHARES, given: STEERS, changes: ['~stops', '~corrections'] },
    stop1ConstantForceMix: { values: SHARES, given: STEERS, changes: ['~stops', '~corrections'] },
    desiredAngularVelocity1: { values: [1, 2], given: { maxTorque1: 1 }, changes: ['~motors'] },
    maxTorque1: { values: [1, 2], changes: ['~motors', '~effects'] },
    desiredAngularVelocity2: { values: [1, 2], given: { maxTorque2: 1 }, changes: ['~motors'] },
    maxTorque2: { values: [1, 2], changes: ['~motors', '~effects'] },
    suspensionForce: {
      values: [0.1, 0.2],
      changes: ['~spring', '~limits', '~corrections', '~effects'],
    },
    suspensionErrorCorrection: {
      values: SHARES,
      given: { suspensionForce: 0.1 },
      changes: ['~spring', '~corrections'],
    },
  },
  SliderJoint: {
    ...jointEdits([], ['.separation', '.separationRate', '~stops', '?~limits']),
    axis: anew(AXES, ['.separation', '.separationRate', '~limits', '~stops']),
    minSeparation: { values: [-1, -2], changes: ['~stops', '~limits'] },
    maxSeparation: { values: [2, 3], changes: ['~stops', '~limits'] },
    sliderForce: { values: [1, 2], changes: ['~effects'] },
    ...stop(),
  },
  UniversalJoint: {
    ...jointEdits([...ANCHORS, ...DIRECTIONS], []),
    anchorPoint: anchorPoint([...ANCHORS, ...DIRECTIONS]),
    axis1: anew(AXES, [...ANCHORS, ...DIRECTIONS]),
    axis2: anew(
      [
        [0, 0, 1],
        [0, 0.6, 0.8],
      ],
      [...ANCHORS, ...DIRECTIONS],
    ),
    stop1Bounce: kept(SHARES),
    stop1ErrorCorrection: kept(SHARES),
    stop2Bounce: kept(SHARES),
    stop2ErrorCorrection: kept(SHARES),
  },
  MotorJoint: {
    ...jointEdits([], motorRates),
    autoCalc: anew(ON, []),
    enabledAxes: { values: [0, 2], given: { axis1Torque: 1 }, changes: ['~effects'] },
    ...motorEdits(1),
    ...motorEdits(2),
    ...motorEdits(3),
  },
};
