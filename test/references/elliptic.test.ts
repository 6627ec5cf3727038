import { pendulumAngle, quarterPeriod, sn } from '../../references/elliptic.js';
import { move } from '../../references/mechanism.js';
import { below, fact } from '../core/helpers.js';

const DEGREE = Math.PI / 180;

fact('quarter periods are those of the tables', () => {
  below(Math.abs(quarterPeriod(0) - Math.PI / 2), 1e-15, '');
  // Abramowitz and Stegun, table 17.2: K at a modular angle of 45° and of 85°.
  below(Math.abs(quarterPeriod(Math.sin(45 * DEGREE)) - 1.854074677301372), 1e-14, '');
  below(Math.abs(quarterPeriod(Math.sin(85 * DEGREE)) - 3.831741999784), 1e-11, '');
});

fact('sn is a sine without a modulus, and one at its quarter period', () => {
  below(Math.abs(sn(0.7, 0) - Math.sin(0.7)), 1e-15, '');
  for (const modulus of [0.1, 0.7, 0.996])
    below(Math.abs(sn(quarterPeriod(modulus), modulus) - 1), 1e-14, `at ${modulus}`);
});

fact('a pendulum of any swing goes as its equation of motion says', () => {
  for (const degrees of [5, 90, 170]) {
    const start = degrees * DEGREE;
    const exact = pendulumAngle(start, 3);
    const followed = move(
      {
        places: (at) => [at, -Math.cos(at)],
        inertias: [1, 0],
        pulls: [0, -9],
      },
      start,
      0,
      64,
    );
    let off = 0;
    for (let frame = 0; frame <= 360; frame++)
      off = Math.max(off, Math.abs(exact(frame / 60) - followed(frame).at));
    // What the slopes of `move` leave, times what the turning point at the top makes of it.
    below(off, 1e-8, `rad, let go at ${degrees}°`);
  }
});
