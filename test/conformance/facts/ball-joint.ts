import { distance, LAG, near } from '../checks.js';
import type { Driver, Fact } from '../fact.js';
import { doublePendulum, pendulum, solve } from '../reference.js';
import { collection, joint, use } from '../scenes.js';
import { ball, jointFacts, MOMENT, pin } from './joint-facts.js';

const at = (x: Driver, name: string): Promise<number[]> => x.get(name, 'position');

/** Half a turn of a pendulum that starts level with its pivot, by the reference: its centre after `t`. */
function swung(pivot: number[], t: number): number[] {
  const [angle] = solve(pendulum(1, MOMENT), [-Math.PI / 2, 0], t) as [number];
  return [pivot[0]! + Math.sin(angle), pivot[1]! - Math.cos(angle), 0];
}

/** Speed at the lowest point of such a swing, m/s. */
const FAST = Math.sqrt((2 * 9.8) / (1 + MOMENT));

const anchorPoint: Fact[] = [
  {
    field: 'anchorPoint',
    says: 'is the pivot: a ball hangs below it, and swings as a pendulum once it lies beside the ball',
    scene: [
      collection({
        bodies: [
          pin({ position: [5, 5, 5], orientation: [0, 0.6, 0.8, 2] }),
          ball('ball', { orientation: [0.6, 0, 0.8, 1] }),
        ],
        joints: [joint('BallJoint', { body1: 'ball', body2: 'pin' }, { anchorPoint: [0, 1, 0] })],
      }),
    ],
    run: async (x) => {
      await x.advance(0.5);
      const hanging = await at(x, 'ball');
      await x.set('joint', 'anchorPoint', [1, 0, 0]);
      await x.advance(0.8);
      return [
        near('hanging', hanging, [0, 0, 0], 0.005, 'm'),
        near('0.8 s on', await at(x, 'ball'), swung([1, 0, 0], 0.8), FAST * LAG, 'm'),
      ];
    },
  },
  {
    field: 'anchorPoint',
    says: 'a ball on a ball swings as a double pendulum: both places, and no gap, after 0.8 s',
    scene: [
      collection({
        bodies: [
          pin({ position: [-1, 0, 0] }),
          ball('upper'),
          ball('lower', { position: [1, 0, 0] }),
        ],
        joints: [
          joint('BallJoint', { body1: 'upper', body2: 'pin' }, { anchorPoint: [-1, 0, 0] }),
          {
            type: 'BallJoint',
            DEF: 'second',
            body1: use('lower'),
            body2: use('upper'),
          },
        ],
      }),
    ],
    run: async (x) => {
      await x.advance(0.8);
      const [a, b] = solve(doublePendulum(MOMENT), [Math.PI / 2, Math.PI / 2, 0, 0], 0.8) as [
        number,
        number,
      ];
      const upper = [-1 + Math.sin(a), -Math.cos(a), 0];
      const lower = [upper[0]! + Math.sin(b), upper[1]! - Math.cos(b), 0];
      const [first, second] = [await at(x, 'upper'), await at(x, 'lower')];
      return [
        // A frame at the speed each has there.
        near('upper ball', first, upper, 0.1, 'm'),
        near('lower ball', second, lower, 0.15, 'm'),
        near('between them', distance(first, second), 1, 0.005, 'm'),
      ];
    },
  },
  {
    field: 'anchorPoint',
    says: 'a swinging ball keeps its energy and its distance for five seconds',
    scene: [
      collection({
        bodies: [pin({ position: [1, 0, 0] }), ball('ball')],
        joints: [joint('BallJoint', { body1: 'ball', body2: 'pin' }, { anchorPoint: [1, 0, 0] })],
      }),
    ],
    run: async (x) => {
      let [energy, arm] = [0, 0];
      for (let i = 0; i < 50; i++) {
        await x.advance(0.1);
        const [place, v, w] = [
          await at(x, 'ball'),
          await x.get('ball', 'linearVelocity'),
          await x.get('ball', 'angularVelocity'),
        ];
        const moving = (Math.hypot(...v) ** 2 + MOMENT * Math.hypot(...w) ** 2) / 2;
        energy = Math.max(energy, Math.abs(moving + 9.8 * place[1]!));
        arm = Math.max(arm, Math.abs(distance(place, [1, 0, 0]) - 1));
      }
      return [
        // 5 % of the 9.8 J between the top and the lowest point.
        near('greatest error of energy', energy, 0, 0.49, 'J'),
        near('greatest error of distance', arm, 0, 0.01, 'm'),
      ];
    },
  },
];

export const ballJoint: Fact[] = [...jointFacts('BallJoint'), ...anchorPoint];
