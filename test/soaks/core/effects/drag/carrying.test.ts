import { describe } from 'node:test';
import type { LevelName } from '../../../../../physics-core/inside.js';
import {
  addBody,
  below,
  box,
  close,
  fact,
  position,
  velocity,
  world,
  type Body,
  type Vec3,
} from '../../../../core/helpers.js';

const TURN = 2 * Math.PI;
const LEVELS: readonly LevelName[] = ['game', 'standard', 'fine', 'precise', 'reference'];

/** A slab, its top at 0 at first, that a listener of each step puts where it is to be at its end. */
async function platform(accuracy: LevelName, field: string, at: (t: number) => number[]) {
  const w = await world({ accuracy });
  w.add('CollisionCollection', { collidables: '*', bounce: 0, frictionCoefficients: [0.8, 0.8] });
  const slab = addBody(w, { fixed: true, position: [0, -0.5, 0], geometry: [box(4, 1, 4)] });
  return {
    w,
    slab,
    /** Calls `look` after each step, with the time. */
    run(seconds: number, look: (t: number) => void): void {
      let n = 0;
      w.on('beforestep', () => slab.set(field, at((n + 1) * w.timeStep)));
      for (; n < seconds / w.timeStep - 0.5; n++) {
        w.step();
        look((n + 1) * w.timeStep);
      }
    },
  };
}

/** How far bodies stray from where they stood on the slab, metres. */
function strays(slab: Body, riders: Body[]): () => number {
  const from = (body: Body): number[] => position(body).map((x, i) => x - position(slab)[i]!);
  const start = riders.map(from);
  return () =>
    Math.max(...riders.flatMap((body, k) => from(body).map((x, i) => Math.abs(x - start[k]![i]!))));
}

const paths: Record<string, (t: number) => Vec3> = {
  'a lift that shakes': (t) => [0, -0.5 + 0.1 * Math.sin(TURN * t), 0],
  'a plate that is pulled': (t) => [t * t, -0.5, 0],
  'a plate that shakes': (t) => [0.05 * (1 - Math.cos(TURN * t)), -0.5, 0],
};

describe('what stands on a body that its author moves', () => {
  for (const [name, path] of Object.entries(paths))
    fact(`${name} has its load with it, at every level`, async () => {
      for (const accuracy of LEVELS) {
        const { w, slab, run } = await platform(accuracy, 'position', path);
        const stone = addBody(w, { position: [0, 0.5, 0], geometry: [box(1)] });
        w.advance(0.5);
        const stray = strays(slab, [stone]);
        let off = 0;
        run(2, () => (off = Math.max(off, stray())));
        below(off, 1e-4, `m at ${accuracy}`);
      }
    });

  fact('a lift that shakes has with it what stands on its load', async () => {
    const { w, slab, run } = await platform('fine', 'position', paths['a lift that shakes']!);
    const stones = [0.5, 1.5].map((y) => addBody(w, { position: [0, y, 0], geometry: [box(1)] }));
    w.advance(1);
    const stray = strays(slab, stones);
    let off = 0;
    run(2, () => (off = Math.max(off, stray())));
    below(off, 1e-3, 'm');
  });

  fact('a turning table has its load with it, round and round', async () => {
    for (const accuracy of LEVELS) {
      const { w, run } = await platform(accuracy, 'orientation', (t) => [0, 1, 0, t]);
      const stone = addBody(w, {
        position: [1, 0.1, 0],
        geometry: [box(0.2)],
        linearVelocity: [0, 0, -1],
        angularVelocity: [0, 1, 0],
      });
      // It lies .1 mm deep, as contacts do.
      run(5, (t) => close(position(stone), [Math.cos(t), 0.1, -Math.sin(t)], 3e-4, accuracy));
    }
  });

  fact('a plate that is pulled away leaves behind what friction can not hold', async () => {
    const { w, run } = await platform('standard', 'position', (t) => [6 * t * t, -0.5, 0]);
    const stone = addBody(w, { position: [0, 0.5, 0], geometry: [box(1)] });
    w.advance(0.5);
    run(0.5, () => {});
    const friction = 0.8 * 9.8;
    // 12 m/s² is more than that.
    close(velocity(stone), [friction * 0.5, 0, 0], 0.02, 'm/s');
    close(position(stone)[0], (friction * 0.5 ** 2) / 2, 0.01, 'm');
  });
});
