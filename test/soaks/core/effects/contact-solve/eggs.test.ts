import { quaternionOf, rotate } from '../../../../../physics-core/base/math.js';
import { axesOf, kineticEnergy } from '../../../../../references/kinetic-energy.js';
import { rollingEllipsoid } from '../../../../../references/rolling-ellipsoid.js';
import {
  above,
  below,
  fact,
  height,
  spin,
  velocity,
  type Body,
  type Vec3,
} from '../../../../core/helpers.js';
import {
  addEgg,
  addRattleback,
  onFloor,
  rattleback,
  type Egg,
} from '../../../../core/effects/contact-solve/eggs.js';
import { G } from '../../../../core/effects/contact-solve/scenes.js';

// What rolls and spins on something round that is no ball: the place where it is touched wanders over it.

const LEVELS = ['game', 'standard', 'fine', 'precise'] as const;

const hen: Egg = { half: [0.035, 0.022, 0.022], mass: 0.06, orientation: [0, 0, 1, 0.05] };

/** How far its long axis is from lying, radians. */
function lean(body: Body): number {
  const [, up] = rotate(quaternionOf(body.get('orientation') as number[]), [1, 0, 0]);
  return Math.asin(Math.min(1, Math.abs(up)));
}

for (const accuracy of LEVELS)
  fact(`an egg that is laid askew rocks for 20 s without loss, at ${accuracy}`, async () => {
    const w = await onFloor(accuracy, 5);
    const [a, b] = [0.3, 0.2];
    const egg = addEgg(w, { half: [a, b, b], mass: 1, orientation: [0, 0, 1, 0.1] }, 0.201);
    let [most, crossings, before] = [0, 0, 1];
    for (let step = 0; w.time < 20; step++) {
      w.step();
      const { 2: rate } = spin(egg);
      if (w.time > 15) most = Math.max(most, lean(egg));
      if (rate * before < 0) crossings++;
      before = rate;
    }
    below(Math.abs(most - 0.1), 0.002, 'rad');
    // Twice in each period of a small swing.
    const rate = Math.sqrt((G * (a ** 2 / b - b)) / ((a ** 2 + b ** 2) / 5 + b ** 2));
    below(Math.abs(crossings - (20 * rate) / Math.PI), 2, 'crossings');
  });

for (const accuracy of LEVELS)
  fact(`an egg that spins at 40 rad/s stays down and gains nothing, at ${accuracy}`, async () => {
    const w = await onFloor(accuracy, 0.2);
    const egg = addEgg(w, { ...hen, angularVelocity: [0, 40, 0] }, 0.0222);
    w.advance(0.1);
    const energy = () =>
      kineticEnergy(egg, velocity(egg), spin(egg), axesOf(egg)) + hen.mass * G * height(egg);
    const start = energy();
    for (let i = 0; i < 60; i++) {
      w.advance(0.05);
      below(Math.abs(energy() / start - 1), 0.002, 'of its energy');
      below(lean(egg), 0.1, 'rad');
    }
  });

/** Jellett's constant, the spin's momentum times how high the middle is, says how fast it turns once it stands. */
for (const accuracy of LEVELS)
  fact(`an egg that spins at 200 rad/s stands up, as eggs do, at ${accuracy}`, async () => {
    const w = await onFloor(accuracy, 0.2);
    const egg = addEgg(w, { ...hen, angularVelocity: [0, 200, 0] }, 0.0222);
    w.advance(6);
    above(lean(egg), 1.45, 'rad');
    const [a, b] = hen.half;
    const upright = (200 * (a ** 2 + b ** 2) * b) / (2 * b ** 2 * a);
    below(Math.abs(spin(egg)[1] / upright - 1), 0.05, 'of the spin');
  });

/** Shares of the truth by which it may turn round too late, and of its spin that it may have less. */
const TURNS: Record<(typeof LEVELS)[number], [late: number, lost: number]> = {
  game: [0.2, 0.7],
  standard: [0.02, 0.2],
  fine: [0.02, 0.1],
  precise: [0.02, 0.1],
};

for (const accuracy of LEVELS)
  fact(
    `a rattleback turns round one way, when and as fast as it should, at ${accuracy}`,
    async () => {
      const stone = rattleback(5);
      const truth = rollingEllipsoid(stone);
      const w = await onFloor(accuracy, 5);
      const body = addRattleback(w, stone, truth.height, truth.velocity);
      const [late, lost] = TURNS[accuracy];
      const asked = firstBelow(0, (frame) => truth.at(frame).spin);
      const found = firstBelow(0, () => (w.advance(1 / 60), spin(body)));
      below(Math.abs(found / asked - 1), late, 'of the time until it turns round');
      w.advance((120 - found) / 60);
      const [end, true_] = [spin(body)[1], truth.at(120).spin[1]];
      below(Math.abs(end / true_ - 1), lost, 'of the spin after 2 s');
    },
  );

function firstBelow(limit: number, spinAt: (frame: number) => Vec3): number {
  for (let frame = 1; frame < 180; frame++) if (spinAt(frame)[1] < limit) return frame;
  return Infinity;
}

for (const accuracy of LEVELS)
  fact(`a rattleback goes on the other way for 2 s, as it should, at ${accuracy}`, async () => {
    const stone = rattleback(-5);
    const truth = rollingEllipsoid(stone);
    const w = await onFloor(accuracy, 5);
    const body = addRattleback(w, stone, truth.height, truth.velocity);
    for (let frame = 1; frame <= 120; frame++) {
      w.advance(1 / 60);
      below(Math.abs(spin(body)[1] - truth.at(frame).spin[1]), 0.06, 'rad/s');
    }
  });
