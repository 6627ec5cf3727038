import {
  addBody,
  addFloor,
  addJoint,
  box,
  close,
  sphere,
  velocity,
  world,
  type Body,
} from '../../../helpers.js';
import type { Row } from '../row.js';

interface Line {
  w: Awaited<ReturnType<typeof world>>;
  balls: Body[];
}

/** Balls of 0.5 m in a row along x without weight; the first one comes at 1 m/s, the others touch. */
async function line(masses: number[], fields: Record<string, unknown> = {}): Promise<Line> {
  const w = await world({ gravity: [0, 0, 0] });
  const balls = masses.map((mass, i) =>
    addBody(w, {
      mass,
      position: [i === 0 ? -0.1 : i, 0, 0],
      linearVelocity: [i === 0 ? 1 : 0, 0, 0],
    }),
  );
  w.add('CollisionCollection', {
    collidables: '*',
    bounce: 1,
    frictionCoefficients: [0, 0],
    ...fields,
  });
  return { w, balls };
}

const speeds = (balls: Body[]): number[] => balls.map((ball) => velocity(ball)[0]);

export const chainRows: Row[] = [
  {
    effect: 'impact propagation',
    fact: 'a blow on a touching row goes on as one hit after the other: the far ball leaves',
    run: async () => {
      const equal = await line([1, 1, 1, 1]);
      equal.w.advance(0.5);
      close(speeds(equal.balls), [0, 0, 0, 1], 1e-4, 'm/s');
      // 1 on 2: -1/3 and 2/3; 2 on 4: -2/9 and 4/9.
      const growing = await line([1, 2, 4]);
      growing.w.advance(0.5);
      close(speeds(growing.balls), [-1 / 3, -2 / 9, 4 / 9], 1e-4, 'm/s');
    },
  },
  {
    effect: 'impact propagation',
    fact: 'with bounce e the last of n balls gets ((1 + e) / 2)ⁿ⁻¹ of the speed, and momentum stays',
    run: async () => {
      const { w, balls } = await line([1, 1, 1, 1], { bounce: 0.5 });
      w.advance(0.5);
      const after = speeds(balls);
      close(after[3]!, 0.75 ** 3, 1e-3, 'm/s');
      close(
        after.reduce((sum, speed) => sum + speed, 0),
        1,
        1e-3,
        'N s',
      );
    },
  },
  {
    effect: 'impact propagation',
    fact: 'who listens hears how hard a hit was that went on',
    run: async () => {
      const { w, balls } = await line([1, 1, 1]);
      const heard: number[] = [];
      balls[0]!.on('collisionstart', (told) => heard.push((told as { impulse: number }).impulse));
      w.advance(0.5);
      close(heard, [1], 1e-3, 'N s');
      // And once more, back from the far end: the first blow is forgotten.
      balls[2]!.event('linearVelocity', [-0.5, 0, 0]);
      w.advance(1.5);
      close(speeds(balls), [-0.5, 0, 0], 1e-3, 'm/s');
      balls[0]!.event('linearVelocity', [2, 0, 0]);
      w.advance(0.7);
      close(speeds(balls), [0, 0, 2], 1e-3, 'm/s');
      close(heard, [1, 2], 1e-3, 'N s');
    },
  },
  {
    effect: 'impact propagation',
    fact: 'a ball that hangs on a rod gives way as its hinge lets it',
    run: async () => {
      const { w, balls } = await line([1, 1, 1]);
      addJoint(w, 'SingleAxisHingeJoint', {
        body2: balls[1],
        anchorPoint: [1, 0.5, 0],
        axis: [0, 0, 1],
      });
      w.advance(0.5);
      // At the hinge's arm r = 0.5 m it weighs I / r² = (0.1 + 0.25) / 0.25 = 1.4 kg.
      const [m, n] = [1, 1.4];
      const second = (2 * m) / (m + n);
      close(speeds(balls)[0]!, (m - n) / (m + n), 0.01, 'm/s, the first');
      close(speeds(balls)[2]!, (second * 2 * n) / (m + n), 0.01, 'm/s, the last');
    },
  },
  {
    effect: 'impact propagation',
    fact: 'a hit acts at its own time of the step: both are where their speeds lead from there',
    run: async () => {
      const { w, balls } = await line([1, 1]);
      balls[0]!.set('linearVelocity', [0.9, 0, 0]);
      w.advance(0.5);
      // The first goes 0.1 m in 13 1/3 steps.
      close(balls[0]!.get('position') as number[], [0, 0, 0], 1e-5, 'm');
      close((balls[1]!.get('position') as number[])[0]!, 1.35, 1e-4, 'm');
    },
  },
  {
    effect: 'continuous collision',
    fact: 'a bullet is stopped by a wall that it would pass in one step',
    run: async () => {
      const w = await world({ gravity: [0, 0, 0] });
      addBody(w, { fixed: true, position: [10, 0, 0], geometry: [box(0.02, 4, 4)] });
      const bullet = addBody(w, { geometry: [sphere(0.05)], linearVelocity: [300, 0, 0] });
      w.advance(0.1);
      close((bullet.get('position') as number[])[0]!, 9.94, 1e-3, 'm');
    },
  },
  {
    effect: 'contact surface',
    fact: 'a block that slides far in a step leaves no contact points behind: it is braked by μ g alone',
    run: async () => {
      const w = await world({ accuracy: 'game', gravity: [0, -9.81, 0] });
      addFloor(w);
      w.add('CollisionCollection', { collidables: '*', frictionCoefficients: [0.4, 0.4] });
      const block = addBody(w, {
        position: [0, 0.1, 0],
        linearVelocity: [6, 0, 0],
        geometry: [box(1, 0.2, 1)],
      });
      w.advance(1);
      close(velocity(block)[0], 6 - 0.4 * 9.81, 2e-3, 'm/s');
    },
  },
];
