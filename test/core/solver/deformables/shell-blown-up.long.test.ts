import { test } from 'node:test';
import { below, close } from '../../helpers.js';
import { ballMesh, moving, Run } from './helpers.js';
import { shake } from './lattices.js';
import { E, RADIUS, shell, step, THICKNESS, within } from './shells.js';

for (const poissonsRatio of [0, 0.4, 0.5])
  test(`a ball grows by p r (1 − ν) / 2 E t, at ${poissonsRatio}`, () => {
    const ball = shell(ballMesh(RADIUS, 3), { poissonsRatio });
    const laid = within(ball);
    new Run(ball).settle(0.15);
    // Of a small share of the volume, a third is that of the radius.
    const grown = (within(ball) / laid - 1) / 3;
    const expected = (5 * RADIUS * (1 - poissonsRatio)) / (2 * E * THICKNESS);
    close(grown, expected, 0.01 * expected);
  });

// ---- what befalls it ---------------------------------------------------------------------------------------------------

const CRUSHED: Record<string, (places: Float64Array) => void> = {
  'pressed flat': (places) => places.forEach((p, j) => (places[j] = j % 3 === 2 ? 0 : p)),
  'turned inside out': (places) => places.forEach((p, j) => (places[j] = j % 3 === 2 ? -p : p)),
  'crushed to a tenth': (places) => places.forEach((p, j) => (places[j] = 0.1 * p)),
};

for (const [how, crush] of Object.entries(CRUSHED))
  test(`a ball that is ${how} is blown up again`, () => {
    const ball = shell(ballMesh(RADIUS, 2), { pressure: 500 });
    const blown = shell(ballMesh(RADIUS, 2), { pressure: 500 });
    new Run(blown).settle(0.2);
    crush(ball.masses.places);
    shake(ball.masses.places, 1e-6);
    step(ball, 1800, 2, 40);
    close(within(ball), within(blown), 0.01 * within(blown));
  });

for (const most of [40, 4, 1])
  test(`nothing that flings it gives it more energy than that, in ${most} parts`, () => {
    const ball = shell(ballMesh(RADIUS, 2), { pressure: 5 });
    // Six times the speed of sound.
    shake(ball.masses.velocities, 200);
    const start = moving(ball.masses);
    for (let n = 0; n < 10; n++) {
      step(ball, 30, 0, most);
      below(moving(ball.masses), 3 * start);
    }
  });
