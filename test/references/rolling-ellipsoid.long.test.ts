import { rollingEllipsoid, type RollingEllipsoid } from '../../references/rolling-ellipsoid.js';
import { below, distance, fact } from '../core/helpers.js';
import { rattleback } from '../core/effects/contact-solve/eggs.js';

fact('a rolling ellipsoid keeps its energy, and half the step changes nothing', () => {
  const [coarse, fine] = [200, 400].map((perFrame) => rollingEllipsoid(rattleback(5), perFrame));
  const { energy } = fine!.at(0);
  for (let frame = 0; frame <= 120; frame += 10) {
    below(distance(coarse!.at(frame).spin, fine!.at(frame).spin), 1e-7, 'rad/s');
    below(Math.abs(fine!.at(frame).energy / energy - 1), 1e-10, 'of the energy');
  }
});

fact('an ellipsoid that rocks a little does so by m g (a² / b - b) / (I + m b²)', () => {
  const [a, b] = [0.3, 0.2];
  const moment = (a ** 2 + b ** 2) / 5;
  const egg: RollingEllipsoid = {
    half: [a, b, b],
    mass: 1,
    inertia: [(2 * b ** 2) / 5, 0, 0, 0, moment, 0, 0, 0, moment],
    gravity: 9.81,
    orientation: [0, 0, Math.sin(5e-5), Math.cos(5e-5)],
    spin: [0, 0, 0],
  };
  const rate = Math.sqrt((9.81 * (a ** 2 / b - b)) / (moment + b ** 2));
  const { at } = rollingEllipsoid(egg, 40);
  for (let frame = 0; frame <= 60; frame++) {
    const truth = -1e-4 * rate * Math.sin((rate * frame) / 60);
    below(Math.abs(at(frame).spin[2] - truth), 1e-9, 'rad/s');
  }
});
