import { inertia, use } from '../conformance/scenes.js';
import { kept, OFF, ON, POINTS, SHARES, TURNS, type Edit } from './edit.js';

const DAMPED = { autoDamp: true };

/** Of a sledge that slides over the ground and pulls a trailer. */
export const bodyEdits: Record<string, Edit> = {
  enabled: {
    values: OFF,
    changes: ['~active', '~awake', '~groups', 'hitch~object', 'hitch~effects', '@touching'],
    parts: true,
  },
  fixed: {
    values: ON,
    changes: [
      // What slides straight on its face does not spin.
      ...['.linearVelocity', '?.angularVelocity', '~mass', '~shape', '~flags', '~effects'],
      ...['~groups', '@meeting', '@touching', 'hitch~object'],
    ],
    // Let go it starts from rest.
    stays: ['.linearVelocity', '.angularVelocity'],
  },
  mass: { values: [2, 3], changes: ['~mass'] },
  inertia: {
    values: [inertia(0.5, 0.6, 0.7), inertia(0.7, 0.6, 0.5)],
    // The rows of the joint lie along the body that has the longer lever, which is the trailer now.
    changes: ['~mass', 'hitch~object'],
  },
  centerOfMass: {
    values: POINTS,
    changes: ['~mass', '~centre', '~shape', '@touching', 'hitch~object', 'hitch~frames'],
  },
  massDensityModel: { values: [use('flat'), use('long')], changes: ['~mass', 'hitch~object'] },
  geometry: {
    values: [[use('looseShape')], []],
    changes: ['~parts', '~shape', '~mass', '~effects', '?~groups', '@meeting', '@touching'],
    stays: ['.geometry', '~parts', '~mass', '~effects', '~groups', '@meeting', 'hitch~object'],
    parts: true,
  },
  position: {
    values: [
      [0, 0.3, 0],
      [0, 0.4, 0],
    ],
    changes: ['hitch.body1AnchorPoint'],
    stays: ['.position', 'hitch.body1AnchorPoint'],
  },
  orientation: {
    values: TURNS,
    changes: ['hitch.body1AnchorPoint'],
    stays: ['.orientation', 'hitch.body1AnchorPoint'],
  },
  linearVelocity: { values: POINTS, changes: [], stays: ['.linearVelocity'] },
  angularVelocity: { values: POINTS, changes: [], stays: ['.angularVelocity'] },
  forces: { values: [[[1, 2, 3]], [[3, 2, 1]]], changes: ['~effects'] },
  torques: { values: [[[1, 2, 3]], [[3, 2, 1]]], changes: ['~effects'] },
  useGlobalGravity: { values: OFF, changes: ['~gravity', '~effects'] },
  autoDamp: { values: ON, changes: ['~damping', '~effects'] },
  linearDampingFactor: { values: SHARES, given: DAMPED, changes: ['~damping'] },
  angularDampingFactor: {
    values: SHARES,
    given: { ...DAMPED, inertia: inertia(1) },
    changes: ['~damping'],
  },
  autoDisable: { values: ON, changes: ['~rest', '~effects'] },
  disableTime: { values: [1, 2], changes: ['~rest'] },
  disableLinearSpeed: { values: [2, 3], changes: ['~rest'] },
  disableAngularSpeed: { values: [2, 3], changes: ['~rest'] },
  useFiniteRotation: kept(ON),
  finiteRotationAxis: kept(POINTS),
  dragMode: kept(['kinematic', 'teleport']),
  draggableBody: kept(ON),
};

/** Of a pole that flies, made of an offset shape and a foot. */
export const shapeEdits: Record<string, Edit> = {
  enabled: {
    values: OFF,
    changes: ['pole~parts', 'pole~shape', 'pole~mass', 'pole~effects', 'pole~groups', '@meeting'],
  },
  translation: {
    values: POINTS,
    changes: ['pole~parts', 'pole~shape', 'pole~mass', 'pole~centre'],
  },
  rotation: { values: TURNS, changes: ['pole~parts', 'pole~shape', 'pole~centre'] },
  shape: {
    values: [[use('flat')], [use('long')]],
    changes: ['pole~parts', 'pole~shape', 'pole~mass'],
    stays: ['.shape', 'pole~parts', 'pole~mass', 'pole~effects', 'pole~groups', '@meeting'],
  },
};

export const offsetEdits: Record<string, Edit> = {
  enabled: shapeEdits.enabled!,
  translation: {
    ...shapeEdits.translation!,
    stays: ['.translation', 'pole~parts', 'pole~mass', 'pole~centre'],
  },
  rotation: shapeEdits.rotation!,
  collidable: {
    values: [use('looseShape'), use('looseBox')],
    // Its ends are other ones.
    changes: ['pole~parts', 'pole~shape', 'pole~mass', '?pole~effects', '?pole~groups', '@meeting'],
    stays: ['.collidable', 'pole~parts', 'pole~mass', 'pole~effects', 'pole~groups', '@meeting'],
  },
};
