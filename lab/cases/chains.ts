import { add, rotate } from '../../physics-core/base/math.js';
import { chainEnd, type Chain } from '../../references/chain.js';
import { ballChain, boxChain } from '../../references/chains.js';
import type { Case, CaseBody, CaseJoint, Vec3 } from '../case.js';
import { apart, frameOf, rounding, worst } from './judging.js';

// Chains let go level. They are chaotic: each is watched as long as neighbouring runs stay together.

/** Seconds. */
const HORIZON = 1;

interface Link extends Pick<CaseBody, 'shape' | 'inertia'> {
  joint: Omit<CaseJoint, 'body1' | 'body2'> & Pick<CaseJoint, 'type'>;
}

const ball: Link = { shape: { type: 'Sphere', radius: 0.1 }, joint: { type: 'BallJoint' } };

/** Nothing of them touches: their inertia is that of the boxes they stand for. */
const hinged = ([moment]: readonly number[]): Link => ({
  inertia: [moment!, moment!, moment!],
  joint: { type: 'SingleAxisHingeJoint', axis: [0, 0, 1] },
});

function scene({ link, centre, masses, gravity }: Chain, { joint, ...body }: Link): Case['scene'] {
  return {
    gravity: [0, -gravity, 0],
    bodies: masses.map((mass, i) => ({
      name: `${i}`,
      mass,
      position: [i * link + centre, 0, 0],
      ...body,
    })),
    joints: masses.map((_, i) => ({
      ...joint,
      body1: `${i}`,
      ...(i > 0 && { body2: `${i - 1}` }),
      anchorPoint: [i * link, 0, 0],
    })),
  };
}

/** `perFrame`: steps of the reference in 1/60 s. */
function chain(
  words: Pick<Case, 'id' | 'name' | 'says'>,
  of: Chain,
  link: Link,
  perFrame: number,
  seconds = HORIZON,
): Case {
  let ends: number[][] | undefined;
  const last = `${of.masses.length - 1}`;
  const tip: Vec3 = [of.link - of.centre, 0, 0];
  const length = of.link * of.masses.length;
  return {
    ...words,
    scene: scene(of, link),
    seconds,
    horizon: seconds,
    unit: 'm',
    size: length,
    singlePrecision: rounding(length, of.gravity * seconds, seconds),
    watch: ({ position, orientation }) => {
      const truth = (ends ??= chainEnd(of, seconds, perFrame));
      return worst((t) =>
        apart(add(position(last), rotate(orientation(last), tip)), truth[frameOf(t)] as Vec3),
      );
    },
  };
}

const double = boxChain(2, 0.5);
const long = boxChain(100);

export const cases: Case[] = [
  chain(
    {
      id: 'pendulum-double',
      name: 'Double pendulum',
      says: 'Two links of 0.5 m on hinges, let go level: the end of the second, against Lagrange.',
    },
    double,
    hinged(double.moments),
    32,
    2,
  ),
  chain(
    {
      id: 'chain-1-20',
      name: 'Chain 1:20',
      says: 'Eight balls on ball joints 1 m apart, the last 20 times as heavy, let go level: the last one, against Lagrange.',
    },
    ballChain(20),
    ball,
    64,
  ),
  chain(
    {
      id: 'chain-1-1000',
      name: 'Chain 1:1000',
      says: 'Eight balls on ball joints 1 m apart, the last 1000 times as heavy, let go level: the last one, against Lagrange.',
    },
    ballChain(1000),
    ball,
    64,
  ),
  chain(
    {
      id: 'chain-100-links',
      name: 'Chain of 100',
      says: 'A hundred hinged links of 0.1 m, let go level: the end of the last, against Lagrange.',
    },
    long,
    hinged(long.moments),
    16,
  ),
];
