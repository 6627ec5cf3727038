import { FRAME, near, ROUGH } from '../checks.js';
import type { Fact } from '../fact.js';
import { at, bead, FREE, speed } from './slider-scenes.js';

export const stops: Fact[] = [
  ...(['minSeparation', 'maxSeparation'] as const).flatMap((field): Fact[] => {
    const sign = field === 'minSeparation' ? -1 : 1;
    return [
      {
        field,
        says: 'is a stop: the bead slides to it and no further, and further once it is moved',
        open: 'negative separations are stops too',
        scene: bead(
          { minSeparation: -0.5, maxSeparation: 0.5 },
          { linearVelocity: [2 * sign, 0, 0] },
        ),
        run: async (x) => {
          await x.advance(1);
          const first = await at(x, 'bead');
          await x.set('joint', field, 0.9 * sign);
          await x.set('bead', 'linearVelocity', [2 * sign, 0, 0]);
          await x.advance(1);
          return [
            near('at 0.5', first, 0.5 * sign, 0.01, 'm'),
            near('at 0.9', await at(x, 'bead'), 0.9 * sign, 0.01, 'm'),
          ];
        },
      },
      {
        field,
        says: 'holds against a steady force of 20 N',
        scene: bead({ [field]: 0.1 * sign }, { forces: [[20 * sign, 0, 0]] }),
        run: async (x) => {
          await x.advance(1);
          return [near('bead', await at(x, 'bead'), 0.1 * sign, 0.001, 'm')];
        },
      },
    ];
  }),
  {
    field: 'minSeparation',
    says: 'above maxSeparation there are no stops',
    scene: bead(FREE, { linearVelocity: [3, 0, 0] }),
    run: async (x) => {
      await x.advance(1);
      return [near('bead', await at(x, 'bead'), 3, 3 * ROUGH, 'm')];
    },
  },
  {
    field: 'stopBounce',
    says: 'is the share of its speed with which a body comes back from a stop',
    scene: bead({ maxSeparation: 0.5, stopBounce: 0.8 }, { linearVelocity: [2, 0, 0] }),
    run: async (x) => {
      await x.advance(0.5);
      const first = await speed(x, 'bead');
      await x.set('joint', 'stopBounce', 0.3);
      await x.set('bead', 'position', [0, 0, 0]);
      await x.set('bead', 'linearVelocity', [2, 0, 0]);
      await x.advance(0.5);
      return [
        near('at 0.8', first, -1.6, 0.01, 'm/s'),
        near('at 0.3', await speed(x, 'bead'), -0.6, 0.01, 'm/s'),
      ];
    },
  },
  {
    field: 'stopErrorCorrection',
    says: 'is the share of an overshoot that a frame repairs',
    open: 'per frame of 1/60 s, whatever the step of the browser',
    scene: bead({ stopErrorCorrection: 0.3 }),
    run: async (x) => {
      const left = async () => {
        await x.set('bead', 'position', [1.2, 0, 0]);
        await x.set('bead', 'linearVelocity', [0, 0, 0]);
        await x.advance(FRAME);
        return (await at(x, 'bead')) - 1;
      };
      await x.advance(FRAME);
      const first = await left();
      await x.set('joint', 'stopErrorCorrection', 0.6);
      return [
        near('left of 0.2 m at 0.3', first, 0.14, 0.005, 'm'),
        near('left of 0.2 m at 0.6', await left(), 0.08, 0.005, 'm'),
      ];
    },
  },
];
