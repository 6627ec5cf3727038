import type { Driver } from '../fact.js';
import { collection, joint, WEIGHTLESS } from '../scenes.js';
import { ball, pin } from './joint-facts.js';

export const TYPE = 'SliderJoint';
export const X = { axis: [1, 0, 0] };
export const FREE = { minSeparation: 1, maxSeparation: 0 };
export const SIGN = 'the sign: apart is positive, along the line that leads from body1 to body2';

export type Fields = Record<string, unknown>;

/** A bead of 2 kg on a rail along X that starts at the pin. As body2 it is what moves apart. */
export const bead = (slider: Fields, fields: Fields = {}, world: Fields = WEIGHTLESS) => [
  collection({
    ...world,
    bodies: [pin({ position: [-1, 0, 0] }), ball('bead', { mass: 2, ...fields })],
    joints: [
      joint(TYPE, { body1: 'pin', body2: 'bead' }, { ...X, forceOutput: ['ALL'], ...slider }),
    ],
  }),
];

/** Two balls of 1 and 3 kg on one line; what they do between them keeps their common centre where it is. */
export const pair = (slider: Fields, first: Fields = {}, second: Fields = {}) => [
  collection({
    ...WEIGHTLESS,
    bodies: [ball('first', first), ball('second', { mass: 3, position: [4, 0, 0], ...second })],
    joints: [
      joint(
        TYPE,
        { body1: 'first', body2: 'second' },
        { ...X, ...FREE, forceOutput: ['ALL'], ...slider },
      ),
    ],
  }),
];

export const at = async (x: Driver, name: string): Promise<number> =>
  (await x.get(name, 'position'))[0];
export const speed = async (x: Driver, name: string): Promise<number> =>
  (await x.get(name, 'linearVelocity'))[0];
