import type { Ammo } from './ammo.js';
import type { BtBody } from './heap.js';
import { ACTIVATION, BODY, COLLISION_FLAG, RIGID_BODY_FLAG } from './offsets.js';

/** Bullet leaves it awake, however slow. */
export const keepAwake = (body: BtBody): void => body.forceActivationState(ACTIVATION.alwaysActive);

/** Bullet leaves it where it is until something that moves touches it. */
export const putToSleep = (body: BtBody): void => body.forceActivationState(ACTIVATION.sleeping);

/** Moved by Bullet, carried along by its author, or fixed. */
export type Mobility = 'dynamic' | 'kinematic' | 'static';

const FLAG = {
  dynamic: 0,
  kinematic: COLLISION_FLAG.kinematic,
  static: COLLISION_FLAG.static,
} as const;

/** Its gravity is its own, not the world's. */
export function setMobility(body: BtBody, mobility: Mobility): void {
  body.setCollisionFlags(FLAG[mobility]);
  body.setFlags(RIGID_BODY_FLAG.ownGravity);
}

/** 1/kg; 0: it does not move. By its heap pointer. */
export const inverseMassOf = ({ HEAPF32 }: Ammo, body: number): number =>
  HEAPF32[(body + BODY.inverseMass) >> 2]!;

/** Whether Bullet moves it: it is neither immovable nor asleep. By its heap pointer. */
export const isAwake = ({ HEAP32, HEAPF32 }: Ammo, body: number): boolean =>
  HEAP32[(body + BODY.activationState) >> 2] !== ACTIVATION.sleeping &&
  HEAPF32[(body + BODY.inverseMass) >> 2] !== 0;
