import { holds } from '../../dynamics/jointed.js';
import { joints } from '../effect/chunks.js';
import type { EffectDescriptor } from '../effect/effect.js';
import type { JointSolve } from './joint-solve.js';
import type { Motors } from './motors.js';
import type { Stops } from './stops.js';
import type { Suspension } from './suspension.js';

export const jointSolve: EffectDescriptor<JointSolve> = {
  name: 'joint solve',
  chunk: joints,
  causes: 'a joint that holds: it stands in the world and some row of it is locked',
  after: {
    forces: 'it reads what pushes its bodies in the step',
    suspension: 'the same',
    dragging: 'the same',
    particles: 'the same',
    water: 'the same',
    ropes: 'they pull at its bodies',
    carrying: 'what is carried takes its ends of joints along',
    motors: 'the same',
    'gyroscopic torque': 'it begins with the spin of free motion',
    'impact propagation': 'what was hit is where its hits take it before joints are closed',
    'pair filter': 'a contact that is taken back wakes none of its rows',
  },
  joint: (joint) => (holds(joint) ? 'joint' : undefined),
};

export const suspension: EffectDescriptor<Suspension> = {
  name: 'suspension',
  chunk: joints,
  causes: 'a DoubleAxisHingeJoint whose suspensionForce is too soft for a row of the solver',
  joint: ({ attached, spring }) => (attached && spring ? 'suspensionForce' : undefined),
};

export const motors: EffectDescriptor<Motors> = {
  name: 'motors',
  chunk: joints,
  causes: 'a torque, force or motor of a joint',
  joint({ attached, drivenBy, motors: heeding }) {
    if (!attached) return undefined;
    return drivenBy ?? (heeding.length > 0 ? 'maxTorque1, maxTorque2' : undefined);
  },
};

export const stops: EffectDescriptor<Stops> = {
  name: 'stops',
  chunk: joints,
  causes: 'a joint whose angle or separation has stops',
  joint: ({ stops: [stop] }) => stop?.reason,
};
