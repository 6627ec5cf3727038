import { test } from 'node:test';
import { Oscillator } from '../../physics-core/effects/joints/oscillator.js';
import { follow } from '../../references/runge-kutta.js';
import { below } from './helpers.js';

// ω², δ and the load of x'' + 2 δ x' + ω² x = a.
const cases: Record<string, [number, number, number]> = {
  undamped: [90, 0, 0],
  'lightly damped, under a load': [90, 0.5, -9.81],
  'critically damped': [90, Math.sqrt(90), -9.81],
  'heavily damped': [90, 40, -9.81],
  'stiffer than the step': [1e6, 30, -9.81],
  'without a spring': [0, 3, -9.81],
};

for (const [name, [omega2, delta, a]] of Object.entries(cases)) {
  for (const perFrame of [1, 2, 8]) {
    void test(`spring and damper, ${name}: exact in steps of 1/${60 * perFrame} s`, () => {
      const truth = follow(
        [0.1, 2],
        ([x, v]) => [v!, a - 2 * delta * v! - omega2 * x!],
        omega2 > 1e5 ? 2048 : 256,
      );
      const dt = 1 / 60 / perFrame;
      const oscillator = new Oscillator();
      let [x, rate] = [0.1, 2];
      oscillator.start(omega2, delta, dt);
      for (let step = 1; step <= 60 * perFrame; step++) {
        rate = oscillator.kept * rate - oscillator.pull * x + oscillator.load * a;
        x += rate * dt;
        if (step === 1) oscillator.goOn(omega2, delta, dt);
        if (step % perFrame === 0) below(Math.abs(x - truth(step / perFrame)[0]!), 1e-8, 'm');
      }
    });
  }
}
