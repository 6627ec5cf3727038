import { jointSolve, type World } from '../../../../physics-core/inside.js';
import { chainEnd, type Chain } from '../../../../references/chain.js';
import { ballChain, boxChain } from '../../../../references/chains.js';
import { addBallChain, addBoxChain, type Jointed } from './scenes.js';
import { dot } from '../../../../physics-core/base/math.js';
import { applyInertia } from '../../../../physics-core/dynamics/inertia.js';
import { levelNames } from '../../../../physics-core/dynamics/levels.js';
import {
  above,
  addBody,
  addJoint,
  below,
  claim,
  distance,
  fact,
  sphere,
  spin,
  velocity,
  world,
} from '../../helpers.js';

const EARTH = [0, -9.81, 0];

/** Ends of a chain each 1/60 s by the reference, at 1/1920 s: within 1 µm of half of that (test/soaks/references). */
const truth = (chain: Chain, seconds: number, push = 0): number[][] =>
  chainEnd(chain, seconds, 32, push);

/** Widest distance of its end from the truth, metres. */
function worstError(w: World, { end }: Jointed, expected: number[][]): number {
  let worst = 0;
  for (const at of expected.slice(1)) {
    w.advance(1 / 60);
    worst = Math.max(worst, distance(end(), at));
  }
  return worst;
}

// Metres at the end of a chain of eight; each bound is three to five times what was measured.
for (const [name, ratio, push, accuracy, seconds, bound] of [
  ['1:20', 20, 0, 'game', 1, 1e-3],
  ['1:20', 20, 0, 'standard', 1, 3e-4],
  ['1:20', 20, 0, 'fine', 1, 1e-4],
  ['1:20', 20, 0, 'precise', 1, 1e-4],
  ['1:20, pushed to the side', 20, 0.5, 'standard', 1, 3e-4],
  ['1:20, pushed to the side', 20, 0.5, 'fine', 1, 1e-4],
  ['1:1000', 1000, 0, 'fine', 1, 1e-3],
  ['1:1000', 1000, 0, 'precise', 2, 1e-3],
  ['1:1000, pushed to the side', 1000, 0.5, 'fine', 1, 1e-3],
  ['1:1000, pushed to the side', 1000, 0.5, 'precise', 2, 1e-3],
] as const) {
  fact(
    `ball chain ${name}: its end goes the true way for ${seconds} s at ${accuracy}`,
    async () => {
      const chain = ballChain(ratio);
      const w = await world({ accuracy, gravity: EARTH });
      if (ratio > 100) claim(w, 'mass-ratio');
      below(worstError(w, addBallChain(w, chain, push), truth(chain, seconds, push)), bound, 'm');
    },
  );
}

// A box takes no moment round about its link, but in a plane it has the reference's.
for (const [accuracy, bound] of [
  ['standard', 1.5e-3],
  ['fine', 4e-4],
  ['precise', 1.5e-4],
] as const) {
  fact(
    `chain of eight boxes on hinges: its end goes the true way for 1 s at ${accuracy}`,
    async () => {
      const chain = boxChain(8, 1);
      const w = await world({ accuracy, gravity: EARTH });
      below(worstError(w, addBoxChain(w, chain), truth(chain, 1)), bound, 'm');
    },
  );
}

fact('without the solve the same chain is more than a hundred times as far off', async () => {
  const chain = ballChain(20);
  const errors: number[] = [];
  for (const on of [true, false]) {
    const w = await world({ accuracy: 'fine', gravity: EARTH });
    w.registry.get(jointSolve).on = on;
    errors.push(worstError(w, addBallChain(w, chain), truth(chain, 1)));
  }
  above(errors[1]! / errors[0]!, 100, 'times');
});

fact(
  'links that whip faster than steps can follow neither part nor take energy from nowhere',
  async () => {
    const w = await world({ accuracy: 'standard', gravity: EARTH });
    const { bodies, joints } = addBallChain(w, ballChain(20));
    let [gap, fastest] = [0, 0];
    for (let i = 0; i < 20 * 120; i++) {
      w.step();
      for (const joint of joints) gap = Math.max(gap, joint.gap);
      for (const body of bodies) fastest = Math.max(fastest, distance(velocity(body), [0, 0, 0]));
    }
    below(gap, 1e-4, 'm, of a link of 1 m');
    // The energy of the whole fall in one of the light balls.
    const fall = 9.81 * (2 * 8 + 0.1 * 28);
    below(fastest, Math.sqrt((2 * fall) / 0.1), 'm/s');
  },
);

fact(
  'a ball on a joint of two axes gains nothing where it has gone as far as that lets it',
  async () => {
    for (const accuracy of levelNames) {
      const w = await world({ gravity: [0, 0, 0], accuracy });
      const ball = addBody(w, {
        position: [-2.177, 0, 1.808],
        geometry: [sphere(0.33)],
        linearVelocity: [0, -4.69, 0],
      });
      addJoint(w, 'DoubleAxisHingeJoint', {
        body1: ball,
        axis1: [0, 0, 1],
        axis2: [2.429, 2.999, 1.762],
      });
      w.step();
      const energy = (): number =>
        dot(velocity(ball), velocity(ball)) / 2 +
        dot(spin(ball), applyInertia(ball, spin(ball))) / 2;
      const before = energy();
      for (let i = 0; i < 2 / w.timeStep; i++) {
        w.step();
        below(energy(), 1.02 * before, 'J');
      }
    }
  },
);
