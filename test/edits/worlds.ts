import { use } from '../conformance/scenes.js';
import { kept, OFF, ON, POINTS, SHARES, type Edit } from './edit.js';

const REST = ['*~rest', 'stone~awake'];
/** Correction and softness of joints. */
const ROWS = ['@solver', '*~corrections'];

/** Of the world: what its bodies take from it changes with it, and sleepers that this concerns wake. */
export const worldEdits: Record<string, Edit> = {
  bodies: kept([[use('sledge')], [use('spare')]]),
  joints: kept([[use('hitch')], [use('BallJoint')]]),
  collider: {
    values: [use('colliders'), use('others')],
    changes: ['*~groups', '*~effects', '@meeting', '@touching', 'stone~awake'],
    stays: ['stone~awake', '*~groups'],
    tells: ['not-in-collider'],
  },
  set_contacts: { values: [[], []], changes: ['~effects'], stays: ['~effects'] },
  enabled: { values: OFF, changes: ['@enabled'] },
  gravity: { values: POINTS, changes: ['*~gravity', 'stone~awake'], stays: ['stone~awake'] },
  preferAccuracy: { values: ON, changes: ROWS },
  iterations: { values: [20, 30], changes: ['@solver'] },
  errorCorrection: { values: SHARES, changes: ROWS },
  constantForceMix: { values: SHARES, changes: ROWS },
  contactSurfaceThickness: { values: SHARES, changes: ['@solver'] },
  maxCorrectionSpeed: { values: SHARES, changes: ['@solver', '~effects'] },
  autoDisable: { values: ON, changes: ['*~rest', '*~effects'] },
  disableTime: { values: [1, 2], changes: REST, stays: ['stone~awake'] },
  disableLinearSpeed: { values: [1, 2], changes: ['*~rest'] },
  disableAngularSpeed: { values: [1, 2], changes: ['*~rest'] },
  accuracy: { values: ['fine', 'game'], changes: ROWS },
  rest: {
    values: ['auto', 'never'],
    changes: ['*~rest', '*~effects'],
    stays: ['.rest', '*~rest', '*~effects'],
  },
  collisionRules: {
    values: ['strict', 'lenient'],
    changes: ['*~groups', '*~effects', '@meeting', '@touching', 'stone~awake'],
    stays: ['stone~awake', '*~groups', '*~effects'],
  },
  timeBudget: kept([3, 5]),
  dragMode: kept(['kinematic', 'teleport']),
  draggableBody: kept(ON),
  debug: { values: ON, changes: ['~effects'] },
  runHidden: kept(ON),
  heapLimit: kept([256, 1024]),
  thread: kept(['worker', 'auto']),
};

/** Parameters that only act by their token. */
const by = (token: string, values: Edit['values'], more: readonly string[] = []): Edit => ({
  values,
  given: { appliedParameters: [token] },
  changes: ['~parameters', ...more],
  stays: more,
});

const EFFECTS = ['ground~effects', 'sledge~effects', 'pole~effects'];

export const parameterEdits = {
  appliedParameters: [['FRICTION_COEFFICIENT-2'], ['BOUNCE', 'SLIP-1']],
  bounce: SHARES,
  minBounceSpeed: SHARES,
  frictionCoefficients: [
    [0.1, 0.2],
    [0.3, 0.2],
  ],
  surfaceSpeed: [
    [1, 2],
    [2, 1],
  ],
  softnessConstantForceMix: SHARES,
  softnessErrorCorrection: SHARES,
} as const;

export const SLIP = [
  [0.1, 0.2],
  [0.2, 0.1],
] as const;

const P = parameterEdits;

/** Of a collection that lists the ground, and by a space the sledge and the pole: nobody else hears of it. */
export const collectionEdits: Record<string, Edit> = {
  collidables: {
    values: [[use('groundShape'), use('trailerShape')], '*'],
    changes: ['sledge~groups', 'trailer~groups', 'pole~groups', '@touching'],
    stays: ['.collidables', '*~groups', '@meeting', 'stone~awake'],
  },
  enabled: { values: OFF, changes: ['@meeting', '@touching', '*~groups', '*~effects'] },
  appliedParameters: {
    values: P.appliedParameters,
    given: { bounce: 0.5 },
    changes: ['~parameters', '@solver'],
  },
  bounce: { values: SHARES, changes: ['~parameters', '@solver', ...EFFECTS], stays: EFFECTS },
  minBounceSpeed: { values: SHARES, changes: ['~parameters'] },
  frictionCoefficients: {
    values: P.frictionCoefficients,
    changes: ['~parameters', ...EFFECTS],
    stays: EFFECTS,
  },
  surfaceSpeed: by('SPEED-1', P.surfaceSpeed, ['@solver', ...EFFECTS]),
  slipFactors: by('SLIP-1', SLIP, ['@solver', ...EFFECTS]),
  softnessConstantForceMix: {
    ...by('CONSTANT_FORCE', SHARES),
    tells: ['approximated-field'],
  },
  softnessErrorCorrection: by('ERROR_REDUCTION', SHARES),
};

export const spaceEdits: Record<string, Edit> = {
  enabled: { values: OFF, changes: ['sledge~groups', 'pole~groups', '@touching'] },
  collidables: {
    values: [[use('trailerShape')], [use('stoneShape')]],
    changes: ['sledge~groups', 'trailer~groups', 'pole~groups', '@touching'],
    stays: ['.collidables', '*~groups', 'stone~awake'],
  },
  useGeometry: { values: ON, changes: [] },
};

/** Of a sensor that watches the sledge on the ground. */
export const sensorEdits: Record<string, Edit> = {
  collider: {
    values: [use('store'), use('others')],
    // What it says of them goes with the next step.
    changes: [],
    stays: ['.collider', '.isActive', '.intersections', '.contacts', '~effects'],
  },
  enabled: {
    values: OFF,
    changes: ['.isActive', '.intersections', '.contacts', '~effects'],
    stays: ['.isActive', '.intersections', '.contacts'],
  },
};
