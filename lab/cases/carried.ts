import type { Case, CaseBody, Vec3 } from '../case.js';
import { drivenCase } from './driven.js';
import { offPaths, roundingOf, type Path } from './paths.js';

// What its author moves has along what stands or hangs on it.

const GRAVITY: Vec3 = [0, -9.81, 0];
const TURN = 2 * Math.PI;

interface Ride {
  id: string;
  name: string;
  says: string;
  seconds: number;
  /** Where the top of the slab is. */
  path: Path;
}

/** A block on a slab that is moved, which holds on to it. */
function ride({ path, seconds, ...words }: Ride): Case {
  const below: Path = (time) => {
    const [x, y, z] = path(time);
    return [x, y - 0.5, z];
  };
  const above: Path = (time) => {
    const [x, y, z] = path(time);
    return [x, y + 0.5, z];
  };
  const cube = (name: string, fields: Partial<CaseBody>): CaseBody => ({ name, ...fields });
  return {
    ...words,
    scene: {
      gravity: GRAVITY,
      bodies: [
        cube('slab', {
          fixed: true,
          shape: { type: 'Box', size: [4, 1, 4] },
          position: below(0),
          path: below,
        }),
        cube('block', { shape: { type: 'Box', size: [1, 1, 1] }, position: above(0) }),
      ],
      contact: { bounce: 0, friction: 0.8 },
    },
    seconds,
    unit: 'm',
    size: 1,
    singlePrecision: roundingOf(1, seconds),
    watch: offPaths({ block: above }),
  };
}

const swinging = drivenCase({
  id: 'carried-pivot',
  name: 'Pendulum on a pivot that is moved',
  says: 'A ball on a ball joint, 1 m below a pivot that is moved to and fro by 0.1 m each second; its place against the equation of motion, in double precision.',
  driven: { arm: 1, way: 0.1, gravity: -GRAVITY[1] },
  seconds: 5,
  size: 0.5,
});

export const cases: Case[] = [
  ride({
    id: 'carried-lift',
    name: 'Block on a shaking lift',
    says: 'A block on a slab that goes up and down by 0.2 m each second; how far it gets from where it stood on the slab.',
    seconds: 3,
    path: (time) => [0, 0.1 * (1 - Math.cos(TURN * time)), 0],
  }),
  ride({
    id: 'carried-plate',
    name: 'Block on a plate that is pulled',
    says: 'A block on a plate that is pulled ever faster, at 2 m/s², friction 0.8; how far it gets from where it stood on the plate.',
    seconds: 2,
    path: (time) => [time ** 2, 0, 0],
  }),
  swinging,
];
