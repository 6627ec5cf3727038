import { shakenBlock } from '../../references/shaken-block.js';
import type { Case } from '../case.js';
import { offPathsOnFloor, roundingOf, type Path } from './paths.js';

// What friction drives.

const GRAVITY = 9.81;

/** m/s of the belt, and N/m of the spring on the block of 1 kg. */
const BELT = 0.5;
const STIFFNESS = 20;
const FRICTION = 0.3;
const SIZE = 0.2;

const rate = Math.sqrt(STIFFNESS);
/** Metres at which the spring pulls as much as friction holds, and after how many seconds on the belt. */
const slipsAt = (FRICTION * GRAVITY) / STIFFNESS;
const slips = slipsAt / BELT;

/** Friction holds and rubs alike, so a block that has slipped swings for ever, and is as fast as the belt once a turn. */
const block: Path = (time) => {
  const x = time < slips ? BELT * time : slipsAt + (BELT / rate) * Math.sin(rate * (time - slips));
  return [x, SIZE / 2, 0];
};
const belt: Path = (time) => [BELT * time, -0.5, 0];

const stickAndSlip: Case = {
  id: 'stick-slip',
  name: 'Stick and slip',
  says: 'A block on a belt of 0.5 m/s, held by a spring that page code makes, friction 0.3: it sticks until the spring pulls with μ m g, then swings by v √(m/k) about there; its place against that.',
  scene: {
    gravity: [0, -GRAVITY, 0],
    bodies: [
      {
        name: 'belt',
        fixed: true,
        shape: { type: 'Box', size: [20, 1, 4] },
        position: belt(0),
        path: belt,
      },
      {
        name: 'block',
        shape: { type: 'Box', size: [SIZE, SIZE, SIZE] },
        position: block(0),
        linearVelocity: [BELT, 0, 0],
        pull: ([x]) => [-STIFFNESS * x, 0, 0],
      },
    ],
    contact: { bounce: 0, friction: FRICTION },
  },
  seconds: 4,
  unit: 'm',
  size: BELT / rate,
  singlePrecision: roundingOf(0.25, 4),
  watch: offPathsOnFloor({ block }),
};

// ---- on a shaken plate -----------------------------------------------------------------------------------------------

const SHAKEN = { way: 0.05, rate: 4 * Math.PI, grip: 0.5 * GRAVITY };
const SHAKEN_SECONDS = 3;

const shakenPlate: Path = (time) => [SHAKEN.way * Math.sin(SHAKEN.rate * time), -0.5, 0];
const placeOfBlock = shakenBlock(SHAKEN, SHAKEN_SECONDS);
const shaken: Path = (time) => [placeOfBlock(time), SIZE / 2, 0];

const shakenOff: Case = {
  id: 'stick-slip-shaken',
  name: 'Stick and slip on a shaken plate',
  says: 'A block on a plate that is moved to and fro by 10 cm twice a second, friction 0.5: it sticks while the plate speeds up by less than μ g, then slips until both are as fast; its place against that.',
  scene: {
    gravity: [0, -GRAVITY, 0],
    bodies: [
      {
        name: 'plate',
        fixed: true,
        shape: { type: 'Box', size: [4, 1, 4] },
        position: shakenPlate(0),
        path: shakenPlate,
      },
      {
        name: 'block',
        shape: { type: 'Box', size: [SIZE, SIZE, SIZE] },
        position: shaken(0),
        linearVelocity: [SHAKEN.way * SHAKEN.rate, 0, 0],
      },
    ],
    contact: { bounce: 0, friction: 0.5 },
  },
  seconds: SHAKEN_SECONDS,
  unit: 'm',
  size: SHAKEN.way,
  singlePrecision: roundingOf(0.25, SHAKEN_SECONDS),
  watch: offPathsOnFloor({ block: shaken }),
};

export const cases: Case[] = [stickAndSlip, shakenOff];
