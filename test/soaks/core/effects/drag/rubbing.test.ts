import { describe } from 'node:test';
import type { LevelName } from '../../../../../physics-core/inside.js';
import { shakenBlock } from '../../../../../references/shaken-block.js';
import {
  above,
  addBody,
  below,
  box,
  close,
  distance,
  fact,
  position,
  world,
} from '../../../../core/helpers.js';

const LEVELS: readonly LevelName[] = ['game', 'standard', 'fine', 'precise', 'reference'];
const FRICTION = 0.5;
const GRIP = FRICTION * 9.8;

/** A plate, its top at 0, and a block of 20 cm on it. */
async function plate(accuracy: LevelName, block: Record<string, unknown>, friction = FRICTION) {
  const w = await world({ accuracy });
  w.add('CollisionCollection', {
    collidables: '*',
    bounce: 0,
    frictionCoefficients: [friction, friction],
  });
  const slab = addBody(w, { fixed: true, position: [0, -0.5, 0], geometry: [box(4, 1, 4)] });
  const stone = addBody(w, { position: [0, 0.1, 0], geometry: [box(0.2)], ...block });
  return { w, slab, stone };
}

type Plate = Awaited<ReturnType<typeof plate>>;

/** A listener of each step puts the plate where it is to be at its end. Calls `look` after each step, with the time. */
function move(
  { w, slab }: Plate,
  to: (t: number) => number[],
  seconds: number,
  look: (t: number) => void,
): void {
  let n = 0;
  const stop = w.on('beforestep', () => slab.set('position', to((n + 1) * w.timeStep)));
  for (; n < seconds / w.timeStep - 0.5; n++) {
    w.step();
    look((n + 1) * w.timeStep);
  }
  stop();
}

/** To and fro by `way` metres. */
const shaken = (way: number, rate: number) => (t: number) => [way * Math.sin(rate * t), -0.5, 0];

async function shake(accuracy: LevelName, way: number, rate: number): Promise<number> {
  const made = await plate(accuracy, { linearVelocity: [way * rate, 0, 0] });
  const truth = shakenBlock({ way, rate, grip: GRIP }, 3);
  let off = 0;
  move(made, shaken(way, rate), 3, (t) => {
    off = Math.max(off, Math.abs(position(made.stone)[0] - truth(t)));
  });
  return off;
}

describe('what lies on a plate that is moved', () => {
  fact('sticks and slips as friction has it, at every level', async () => {
    for (const accuracy of LEVELS)
      below(await shake(accuracy, 0.05, 4 * Math.PI), 3e-5, `m at ${accuracy}`);
  });

  fact('slips this way and that where it never sticks', async () => {
    below(await shake('fine', 0.2, 4 * Math.PI), 1e-5, 'm');
  });

  fact('slips in a circle of μ g / ω² on a plate that goes in a wider one', async () => {
    const [wide, rate] = [0.1, 10];
    const narrow = GRIP / rate ** 2;
    const behind = Math.acos(narrow / wide);
    const round = (radius: number, angle: number, y: number): number[] => [
      radius * Math.cos(angle),
      y,
      radius * Math.sin(angle),
    ];
    const truth = (t: number): number[] => round(narrow, rate * t - behind, 0.1);
    for (const accuracy of ['standard', 'precise'] as const) {
      const made = await plate(accuracy, {
        position: truth(0),
        linearVelocity: round(narrow * rate, Math.PI / 2 - behind, 0),
      });
      made.slab.set('position', round(wide, 0, -0.5));
      let off = 0;
      move(
        made,
        (t) => round(wide, rate * t, -0.5),
        3,
        (t) => {
          off = Math.max(off, distance(position(made.stone), truth(t)));
        },
      );
      below(off, 2e-4, `m at ${accuracy}`);
    }
  });

  fact('is where it should be when frames move the plate, each several steps long', async () => {
    const [way, rate, frame] = [0.05, 4 * Math.PI, 1 / 60];
    for (const accuracy of ['standard', 'reference'] as const) {
      const { w, slab, stone } = await plate(accuracy, { linearVelocity: [way * rate, 0, 0] });
      const truth = shakenBlock({ way, rate, grip: GRIP }, 3);
      let [least, most] = [Infinity, -Infinity];
      for (let i = 1; i <= 150; i++) {
        slab.set('position', shaken(way, rate)(i * frame));
        w.advance(frame);
        // The first frame says where the plate is, not where it goes.
        if (i < 30) continue;
        const off = position(stone)[0] - truth(i * frame);
        [least, most] = [Math.min(least, off), Math.max(most, off)];
      }
      below(most - least, 3e-5, `m at ${accuracy}`);
    }
  });

  fact(
    'that is struck as it rides a belt slides straight across it until it rides again',
    async () => {
      const [belt, kick] = [0.5, 1];
      const made = await plate('standard', { linearVelocity: [belt, 0, 0] });
      const goes = (t: number): number[] => [belt * t, -0.5, 0];
      move(made, goes, 0.5, () => {});
      made.stone.applyImpulse([0, 0, kick * (made.stone.get('mass') as number)]);
      move(
        made,
        (t) => goes(0.5 + t),
        0.5,
        (t) => {
          const slid = Math.min(t, kick / GRIP);
          const across = kick * slid - (GRIP * slid ** 2) / 2;
          close(position(made.stone), [belt * (0.5 + t), 0.1, across], 2e-5, 'm');
        },
      );
    },
  );

  fact('what stops at once leaves it slipping, from the speed that both had', async () => {
    const made = await plate('fine', { linearVelocity: [1, 0, 0] });
    let stopped = 0;
    move(
      made,
      (t) => [Math.min(t, 0.5), -0.5, 0],
      1.2,
      () => {
        stopped = position(made.stone)[0];
      },
    );
    close(stopped, 0.5 + 1 / (2 * GRIP), 2e-3, 'm');
  });

  fact('sticks and slips on a belt by a spring of page code as by one that is known', async () => {
    const [belt, stiffness, friction] = [0.5, 20, 0.3];
    const rate = Math.sqrt(stiffness);
    const slipsAt = (friction * 9.8) / stiffness;
    const slips = slipsAt / belt;
    const truth = (t: number): number =>
      t < slips ? belt * t : slipsAt + (belt / rate) * Math.sin(rate * (t - slips));
    for (const accuracy of LEVELS) {
      const made = await plate(accuracy, { mass: 1, linearVelocity: [belt, 0, 0] }, friction);
      const { w, stone } = made;
      w.on('beforestep', () => stone.set('forces', [[-stiffness * position(stone)[0], 0, 0]]));
      let off = 0;
      move(
        made,
        (t) => [belt * t, -0.5, 0],
        3,
        (t) => {
          off = Math.max(off, Math.abs(position(stone)[0] - truth(t)));
        },
      );
      below(off, 2e-5, `m at ${accuracy}`);
    }
  });

  fact('neither gains nor loses where such a spring is stiff for its steps', async () => {
    const [belt, rate, friction] = [0.5, 30, 0.3];
    const made = await plate('standard', { mass: 1, linearVelocity: [belt, 0, 0] }, friction);
    const { w, stone } = made;
    w.on('beforestep', () => stone.set('forces', [[-(rate ** 2) * position(stone)[0], 0, 0]]));
    let widest = 0;
    move(
      made,
      (t) => [belt * t, -0.5, 0],
      3,
      (t) => {
        if (t < 2) return;
        widest = Math.max(widest, Math.abs(position(stone)[0] - (friction * 9.8) / rate ** 2));
      },
    );
    close(widest / (belt / rate), 1, 0.01, 'of the amplitude');
  });

  fact('tips over on a plate that is pulled by more than its width to its height', async () => {
    const over = async (share: number): Promise<number> => {
      const made = await plate(
        'reference',
        { position: [0, 0.5, 0], geometry: [box(0.2, 1, 0.2)] },
        0.8,
      );
      move(
        made,
        (t) => [(share * 9.8 * t ** 2) / 2, -0.5, 0],
        1,
        () => {},
      );
      return (made.stone.get('orientation') as number[])[3]!;
    };
    below(await over(0.19), 1e-3, 'rad');
    above(await over(0.21), 0.15, 'rad');
  });

  fact('two restores of a shaken plate run alike, bit for bit', async () => {
    const made = await plate('standard', { linearVelocity: [0.2 * Math.PI, 0, 0] });
    const { w, stone } = made;
    move(made, shaken(0.05, 4 * Math.PI), 0.55, () => {});
    const state = w.snapshot();
    const run = (): number[] => {
      w.restore(state);
      const places: number[] = [];
      move(
        made,
        (t) => shaken(0.05, 4 * Math.PI)(0.55 + t),
        0.5,
        () => {
          places.push(...position(stone));
        },
      );
      return places;
    };
    close(run(), run(), 0);
  });
});
