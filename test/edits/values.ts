import { inertia, use } from '../conformance/scenes.js';

/** Two values of a field that act, neither its default, and not the one it has in the scene. */
export type Values = readonly [unknown, unknown];

const ANGLES: Values = [0.5, 0.7];
const SHARES: Values = [0.25, 0.6];
const POINTS: Values = [
  [0.1, 0.2, 0.3],
  [0.3, 0.2, 0.1],
];
const ON: Values = [true, false];
const OFF: Values = [false, true];

/** Fields that mean the same wherever they stand. */
const common: Record<string, Values> = {
  metadata: [use('data'), use('moreData')],
  bboxCenter: POINTS,
  bboxSize: POINTS,
  bboxDisplay: ON,
  visible: OFF,
  description: ['one', 'two'],
  enabled: OFF,
  translation: POINTS,
  rotation: [
    [0, 1, 0, 0.5],
    [1, 0, 0, 0.5],
  ],
};

const joint: Record<string, Values> = {
  body1: [use('spare'), use('pole')],
  body2: [use('spare'), use('pole')],
  anchorPoint: POINTS,
  forceOutput: [['ALL'], ['NONE', 'ALL']],
};

const stop: Record<string, Values> = {
  stopBounce: SHARES,
  stopErrorCorrection: SHARES,
};

const AXES: Values = [
  [0.6, 0, 0.8],
  [0.8, 0, 0.6],
];

const rest: Record<string, Values> = {
  disableTime: [1, 2],
  disableLinearSpeed: [1, 2],
  disableAngularSpeed: [1, 2],
};

const parameters: Record<string, Values> = {
  appliedParameters: [['FRICTION_COEFFICIENT-2'], ['BOUNCE', 'SLIP-1']],
  bounce: SHARES,
  minBounceSpeed: SHARES,
  frictionCoefficients: [
    [0.1, 0.2],
    [0.3, 0.2],
  ],
  softnessConstantForceMix: SHARES,
  softnessErrorCorrection: SHARES,
  surfaceSpeed: [
    [1, 2],
    [2, 1],
  ],
};

const slip: Values = [
  [0.1, 0.2],
  [0.2, 0.1],
];

const motorAxis = (n: number): Record<string, Values> => ({
  [`motor${n}Axis`]: AXES,
  [`axis${n}Angle`]: ANGLES,
  [`axis${n}Torque`]: [2, 3],
  [`stop${n}Bounce`]: SHARES,
  [`stop${n}ErrorCorrection`]: SHARES,
});

const own: Record<string, Record<string, Values>> = {
  RigidBodyCollection: {
    ...rest,
    bodies: [[use('sledge')], [use('spare')]],
    joints: [[use('hitch')], [use('BallJoint')]],
    collider: [use('colliders'), null],
    set_contacts: [[], []],
    gravity: POINTS,
    preferAccuracy: ON,
    iterations: [20, 30],
    errorCorrection: SHARES,
    constantForceMix: SHARES,
    contactSurfaceThickness: SHARES,
    maxCorrectionSpeed: SHARES,
    autoDisable: ON,
    accuracy: ['fine', 'game'],
    rest: ['never', 'auto'],
    collisionRules: ['strict', 'lenient'],
    runHidden: ON,
    heapLimit: [256, 1024],
  },
  RigidBody: {
    ...rest,
    fixed: ON,
    mass: [2, 3],
    inertia: [inertia(0.5, 0.6, 0.7), inertia(0.7, 0.6, 0.5)],
    centerOfMass: POINTS,
    massDensityModel: [use('flat'), use('long')],
    geometry: [[use('looseShape')], []],
    position: [
      [0, 0.3, 0],
      [0, 0.4, 0],
    ],
    orientation: common.rotation!,
    linearVelocity: POINTS,
    angularVelocity: POINTS,
    forces: [[[1, 2, 3]], [[3, 2, 1]]],
    torques: [[[1, 2, 3]], [[3, 2, 1]]],
    useGlobalGravity: OFF,
    autoDamp: ON,
    linearDampingFactor: SHARES,
    angularDampingFactor: SHARES,
    autoDisable: ON,
    useFiniteRotation: ON,
    finiteRotationAxis: POINTS,
  },
  CollidableShape: { shape: [[use('flat')], [use('long')]] },
  CollidableOffset: { collidable: [use('looseShape'), null] },
  CollisionCollection: {
    ...parameters,
    collidables: [[use('groundShape'), use('trailerShape')], '*'],
    slipFactors: slip,
  },
  CollisionSpace: { collidables: [[use('trailerShape')], [use('stoneShape')]], useGeometry: ON },
  CollisionSensor: { collider: [null, use('colliders')] },
  Contact: {
    ...parameters,
    slipCoefficients: slip,
    body1: joint.body1!,
    body2: joint.body2!,
    contactNormal: AXES,
    depth: SHARES,
    frictionDirection: AXES,
    geometry1: [use('spareShape'), use('poleShape')],
    geometry2: [use('spareShape'), use('poleShape')],
    position: POINTS,
  },
  BallJoint: joint,
  SingleAxisHingeJoint: {
    ...joint,
    ...stop,
    axis: AXES,
    minAngle: [-0.5, -0.7],
    maxAngle: ANGLES,
  },
  DoubleAxisHingeJoint: {
    ...joint,
    axis1: AXES,
    axis2: AXES,
    minAngle1: [-0.5, -0.7],
    maxAngle1: ANGLES,
    stop1Bounce: SHARES,
    stop1ErrorCorrection: SHARES,
    stop1ConstantForceMix: SHARES,
    desiredAngularVelocity1: [1, 2],
    maxTorque1: [1, 2],
    desiredAngularVelocity2: [1, 2],
    maxTorque2: [1, 2],
    suspensionForce: [0.1, 0.2],
    suspensionErrorCorrection: SHARES,
  },
  SliderJoint: {
    ...joint,
    ...stop,
    axis: AXES,
    minSeparation: [-1, -2],
    maxSeparation: [2, 3],
    sliderForce: [1, 2],
  },
  UniversalJoint: {
    ...joint,
    axis1: AXES,
    axis2: AXES,
    stop1Bounce: SHARES,
    stop1ErrorCorrection: SHARES,
    stop2Bounce: SHARES,
    stop2ErrorCorrection: SHARES,
  },
  MotorJoint: {
    ...joint,
    autoCalc: ON,
    enabledAxes: [2, 3],
    ...motorAxis(1),
    ...motorAxis(2),
    ...motorAxis(3),
  },
};

export const valuesOf = (type: string, field: string): Values | undefined =>
  own[type]?.[field] ?? common[field];
