import type { World } from '../../../../physics-core/inside.js';
import {
  addBody,
  below,
  box,
  claim,
  close,
  distance,
  fact,
  height,
  sphere,
  velocity,
  world,
  type Node,
} from '../../helpers.js';
import { flat, LEVELS, places } from '../deformables/helpers.js';
import { addSea, G, THICK } from './helpers.js';

const WATER = 1000;

/** Metres: the lowest, and the mean of all points. */
const lowest = (node: Node): number => Math.min(...places(node).map(([, y]) => y));
const middle = (node: Node): number =>
  places(node).reduce((sum, [, y]) => sum + y, 0) / places(node).length;

/** m/s, upward, over half a second. */
function speedOf(w: World, node: Node): number {
  const before = middle(node);
  w.advance(0.5);
  return 2 * (middle(node) - before);
}

const known = async (w: World, node: Node): Promise<Record<string, number>> => {
  const { bullet } = (await w.ask('explain', node as never)) as { bullet?: { water?: object } };
  return (bullet?.water ?? {}) as never;
};

/** Jelly that its own weight hardly deforms. */
const FIRM = { youngsModulus: 2e5, poissonsRatio: 0.3 };

for (const accuracy of LEVELS)
  fact(`a soft box floats with as much of it below as it is dense, ${accuracy}`, async () => {
    const w = await world({ accuracy } as never);
    addSea(w, THICK);
    const jelly = w.add('SoftBody', {
      ...FIRM,
      mass: 0.5 * WATER * 0.032,
      geometry: { ...box(0.4, 0.2, 0.4), translation: [0, 0.02, 0] },
    });
    w.advance(2.5);
    const { displaced } = await known(w, jelly);
    close(displaced! * WATER, 16, 0.16);
    close(lowest(jelly), -0.1, 1e-3);
  });

fact(
  'a soft cube that is twice as dense as water sinks as its weight and its drag have it',
  async () => {
    const w = await world();
    addSea(w, { damping: 0 });
    const stone = w.add('SoftBody', {
      youngsModulus: 1e6,
      mass: 16,
      geometry: { ...box(0.2), translation: [0, -1, 0] },
    });
    w.advance(1);
    // m v' = (m - ρ V) g - ½ ρ c A v²: it goes by v²/a ln cosh (a t / v), v its terminal speed; a its start.
    const start = G / 2;
    const terminal = Math.sqrt((2 * 16 * start) / (WATER * 0.04));
    const fallen = (terminal ** 2 / start) * Math.log(Math.cosh(start / terminal));
    close(middle(stone), -1 - fallen, 0.01 * fallen);
    close(speedOf(w, stone), -terminal, 0.03 * terminal);
  },
);

fact(
  'what is as dense as water stays where it is and as it is, however soft and however deep',
  async () => {
    for (const depth of [1, 100]) {
      const w = await world();
      addSea(w, { damping: 0 });
      const jelly = w.add('SoftBody', {
        youngsModulus: 1000,
        mass: 8,
        geometry: { ...box(0.2), translation: [0, -depth, 0] },
      });
      const laid = places(jelly);
      w.advance(2);
      places(jelly).forEach((place, i) => below(distance(place, laid[i]!), 1e-9));
    }
  },
);

fact('a ball full of gas floats on what it displaces', async () => {
  const w = await world();
  addSea(w, THICK);
  const ball = w.add('SoftBody', {
    mass: 2,
    youngsModulus: 1e6,
    pressure: 2000,
    damping: 2,
    geometry: { ...sphere(0.2), translation: [0, 0.1, 0] },
  });
  w.advance(3);
  const { displaced } = await known(w, ball);
  // It goes on breathing a little.
  close(displaced! * WATER, 2, 0.06);
});

for (const accuracy of LEVELS)
  fact(
    `a cloth sinks at the speed at which its weight and its drag are even, ${accuracy}`,
    async () => {
      for (const [mass, thickness] of [
        [0.3, 0],
        [2, 0.001],
      ] as const) {
        const w = await world({ accuracy } as never);
        addSea(w, { damping: 0, liftCoefficient: 0 });
        const cloth = w.add('Cloth', { mass, thickness, geometry: flat(8, 1, -0.1) });
        w.advance(1);
        const terminal = Math.sqrt((2 * (mass - WATER * thickness) * G) / WATER);
        close(speedOf(w, cloth), -terminal, 0.02 * terminal);
      }
    },
  );

fact(
  'a cloth that is lighter than water lies on it, with half of its thickness below at half its density',
  async () => {
    const w = await world();
    addSea(w, { damping: 2 });
    const cloth = w.add('Cloth', { mass: 0.5, thickness: 0.001, geometry: flat(8, 1, 0.05) });
    w.advance(3);
    const { displaced } = await known(w, cloth);
    close(displaced! * WATER, 0.5, 0.01);
    close(middle(cloth), 0, 5e-4);
  },
);

fact('a cloth that is held in a river pulls what holds it by its drag', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  addSea(w, { flow: [0, 0, 1], damping: 0, liftCoefficient: 0 });
  const sheet = { size: [1, 1], subdivision: [4, 4], mass: 0.2, thickness: 0 };
  const cloth = w.add('Cloth', sheet);
  const barge = addBody(w, { mass: 1e4, geometry: [] });
  places(cloth).forEach((position, index) => {
    w.add('SoftBodyAttachment', { softBody: cloth, index, body: barge, position });
  });
  w.step();
  const before = velocity(barge)[2];
  w.step(10);
  const pull = (1e4 * (velocity(barge)[2] - before)) / (10 * w.timeStep);
  // Half of it is below: ½ ρ c A u².
  close(pull, WATER / 4, 0.01 * WATER);
});

const RADIUS = 0.01;
const CROSS = Math.PI * RADIUS * RADIUS;

for (const accuracy of LEVELS) {
  fact(
    `a level rope sinks at the speed at which its weight and its drag are even, ${accuracy}`,
    async () => {
      const w = await world({ accuracy } as never);
      addSea(w, { damping: 0 });
      const rope = w.add('Rope', {
        points: [
          [-1, -0.1, 0],
          [1, -0.1, 0],
        ],
        segments: 20,
        mass: 2 * WATER * CROSS * 2,
        radius: RADIUS,
      });
      w.advance(1);
      const terminal = Math.sqrt(G * Math.PI * RADIUS);
      close(speedOf(w, rope), -terminal, 0.005 * terminal);
    },
  );

  fact(`a light rope lies on the water, as deep as it is dense, ${accuracy}`, async () => {
    for (const share of [0.1, 0.5, 0.9]) {
      const w = await world({ accuracy } as never);
      addSea(w, { damping: 2 });
      const rope = w.add('Rope', {
        points: [
          [-1, 0.1, 0],
          [1, 0, 0],
        ],
        segments: 20,
        mass: share * WATER * CROSS * 2,
        radius: RADIUS,
      });
      w.advance(5);
      for (const [, y] of places(rope)) close(y, (0.5 - share) * 2 * RADIUS, 2e-4);
    }
  });

  fact(`a float bears what a rope weighs in water, ${accuracy}`, async () => {
    const w = await world({ accuracy } as never);
    addSea(w, THICK);
    const float = addBody(w, { mass: 4, geometry: [box(0.2)] });
    const volume = 2 * CROSS;
    const rope = w.add('Rope', {
      points: [
        [0, -0.1, 0],
        [0, -2.1, 0],
      ],
      segments: 20,
      mass: 3 * WATER * volume,
      radius: RADIUS,
    });
    w.add('SoftBodyAttachment', { softBody: rope, index: 0, body: float, position: [0, -0.1, 0] });
    w.advance(3);
    close(height(float), 0.1 - (4 + 2 * WATER * volume) / WATER / 0.04, 2e-4);
  });
}

fact(
  'a rope in a river trails at the angle at which its weight and its drag are even across it',
  async () => {
    const w = await world();
    addSea(w, { flow: [1, 0, 0], damping: 0 });
    const rope = w.add('Rope', {
      points: [
        [0, -1, 0],
        [1, -2, 0],
      ],
      segments: 20,
      mass: 2 * WATER * CROSS * Math.SQRT2,
      radius: RADIUS,
      fixedIndex: [0],
    });
    w.advance(10);
    // A straight line at an angle φ from the flow: w cos φ = R sin² φ, of a metre.
    const k = (WATER * CROSS * G) / (WATER * RADIUS);
    const [x, y] = places(rope).at(-1)!;
    close(Math.atan2(-1 - y, x), Math.acos((Math.sqrt(k * k + 4) - k) / 2), 0.01);
  },
);

fact('where oil lies on water each lifts by what is in it', async () => {
  const w = await world();
  w.add('WaterVolume', { size: [20, 8, 20], position: [0, -4, 0], ...THICK });
  w.add('WaterVolume', { size: [20, 9, 20], position: [0, -3.5, 0], density: 800, ...THICK });
  const jelly = w.add('SoftBody', {
    ...FIRM,
    mass: 0.9 * WATER * 0.032,
    geometry: { ...box(0.4, 0.2, 0.4), translation: [0, 0.02, 0] },
  });
  w.advance(4);
  // 1000 d + 800 (h - d) = 900 h
  close(lowest(jelly), -0.1, 3e-3);
});

for (const accuracy of LEVELS)
  fact(`what is far lighter than water neither explodes nor leaps, ${accuracy}`, async () => {
    const w = await world({ accuracy } as never);
    // What is pressed flat is stiffer.
    if (accuracy === 'game') claim(w, 'soft-too-stiff');
    addSea(w);
    const light = [
      w.add('SoftBody', {
        mass: 0.032,
        geometry: { ...box(0.4, 0.2, 0.4), translation: [0, -0.3, 0] },
      }),
      w.add('SoftBody', {
        mass: 2,
        pressure: 1000,
        youngsModulus: 3e5,
        damping: 1,
        geometry: { ...sphere(0.2), translation: [2, -0.3, 0] },
      }),
      w.add('Cloth', {
        mass: 0.01,
        thickness: 0.01,
        geometry: { ...flat(6, 1, -0.3), translation: [4, 0, 0] },
      }),
      w.add('Rope', {
        points: [
          [6, -0.3, 0],
          [7, -0.3, 0],
        ],
        segments: 20,
        mass: 0.001,
        radius: 0.02,
      }),
    ];
    for (let i = 0; i < 20; i++) {
      w.advance(0.1);
      for (const node of light)
        for (const place of places(node))
          below(Math.abs(place[1]), 2, `${node.type.name} at ${place.join(' ')}`);
    }
  });

fact('a solid whose surface is laid amiss floats by its cells', async () => {
  const w = await world();
  addSea(w, THICK);
  const coord = [0, 1, 2, 3, 4, 5, 6, 7].flatMap((c) => [
    c & 1 ? 0.2 : -0.2,
    c & 2 ? 0.12 : -0.08,
    c & 4 ? 0.2 : -0.2,
  ]);
  // The first triangle looks inward.
  const bottom = [0, 4, 1, 1, 5, 4];
  const sides = [
    2, 7, 3, 2, 6, 7, 0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 6, 2, 0, 4, 6, 1, 3, 5, 3, 7, 5,
  ];
  const jelly = w.add('SoftBody', {
    ...FIRM,
    mass: 16,
    geometry: { type: 'IndexedTriangleSet', coord, index: [...bottom, ...sides] },
  });
  w.advance(2.5);
  close(lowest(jelly), -0.1, 0.01);
});
