import { addBody, below, distance, fact, sphere, velocity, world } from '../../helpers.js';
import { addRope, G, LEVELS, line, places, tie } from './helpers.js';

/** m/s of what falls by its length, of 2 m. */
const FALLEN = Math.sqrt(2 * G * 2);

for (const accuracy of LEVELS)
  fact(`a heavy end that is let go level falls, and flings nothing, at ${accuracy}`, async () => {
    const w = await world({ accuracy });
    const rope = addRope(w, line(40, 2, [0, 0, 0], [1, 0, 0]), {
      fixedIndex: [0],
    });
    const body = addBody(w, {
      mass: 500,
      position: [2, 0, 0],
      geometry: [sphere(0.1)],
    });
    tie(w, rope, 40, { body });
    let before = places(rope);
    let [bodies, points, energy] = [0, 0, 0];
    for (let i = 0; i < 5 / w.timeStep; i++) {
      w.step();
      const now = places(rope);
      const speed = Math.hypot(...velocity(body));
      points = Math.max(points, ...now.map((at, n) => distance(at, before[n]!) / w.timeStep));
      bodies = Math.max(bodies, speed);
      // Its speed is of the middle of the step.
      energy = Math.max(energy, speed ** 2 / 2 + (G * (now[40]![1] + before[40]![1])) / 2);
      before = now;
    }
    below(bodies, 1.002 * FALLEN);
    below(energy, 0.005 * 2 * G);
    below(points, 3 * FALLEN);
  });
