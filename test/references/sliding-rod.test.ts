import { leavesAt, slidingRod, type SlidingRod } from '../../references/sliding-rod.js';
import { below, fact } from '../core/helpers.js';

const thin: SlidingRod = { length: 2, thickness: 0, start: 0.3, gravity: 9.81 };

fact('a thin rod leaves the wall at two thirds of its height', () => {
  below(Math.abs(Math.cos(leavesAt(thin)) - (2 / 3) * Math.cos(0.3)), 1e-14, 'of the height');
});

fact('a rod that slides down a wall keeps its energy, and half the step changes nothing', () => {
  const rod = { ...thin, thickness: 0.1 };
  const [coarse, fine] = [slidingRod(rod, 64), slidingRod(rod, 128)];
  for (let frame = 0; frame <= 54; frame++) {
    const [a, b] = [coarse(frame), fine(frame)];
    below(Math.hypot(a.x - b.x, a.y - b.y), 1e-9, 'm');
  }
  const [before, after] = [53, 54].map((frame) => fine(frame));
  const between = fine(0).y - (before!.y + after!.y) / 2;
  const [x, y, turn] = (['x', 'y', 'angle'] as const).map(
    (name) => (after![name] - before![name]) * 60,
  );
  const moment = (2 ** 2 + 0.1 ** 2) / 12;
  const moving = (x! ** 2 + y! ** 2 + moment * turn! ** 2) / 2;
  // Mean speeds of a frame: they leave out what the acceleration within it adds.
  below(Math.abs(moving / (9.81 * between) - 1), 2e-3, 'of the energy');
});
