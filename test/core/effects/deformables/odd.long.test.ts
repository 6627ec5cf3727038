import type { World } from '../../../../physics-core/inside.js';
import {
  addBody,
  addFloor,
  below,
  claim,
  close,
  codes,
  distance,
  fact,
  position,
  sphere,
  told,
  velocity,
  WEIGHTLESS,
  world,
  type Node,
  type Vec3,
} from '../../helpers.js';
import { deformables } from '../../../../physics-core/effects/deformables/effects.js';
import { steppingOf } from '../../thread/at-once.js';
import { flat, place, places, tie } from './helpers.js';

/** m/s and m: nothing here goes faster, or farther. */
const FAST = 50;
const FAR = 200;

/** Goes on for so many steps; no point of it is ever nowhere, too fast or too far. */
function goOn(w: World, node: Node, steps = 120): void {
  let before = places(node);
  for (let i = 0; i < steps; i++) {
    w.step();
    const now = places(node);
    now.forEach((at, n) => {
      below(distance(at, before[n]!) / w.timeStep, FAST, `point ${n}, step ${i}`);
      below(Math.hypot(...at), FAR, `point ${n}, step ${i}`);
    });
    before = now;
  }
}

/** What is pulled about may say that it is too stiff. */
function mayBeTooStiff(w: World): World {
  w.on('problem', (problem) => {
    const { code } = problem as { code: string };
    if (code === 'soft-too-stiff') claim(w, code);
  });
  return w;
}

const surface = (index: number[], ...coord: number[]) => ({
  type: 'IndexedTriangleSet',
  coord,
  index,
});

// ---- surfaces that are odd -----------------------------------------------------------------------------------------------

const ODD: Record<string, ReturnType<typeof surface>> = {
  'a triangle': surface([0, 1, 2], 0, 0, 0, 1, 0, 0, 0, 1, 0),
  'a triangle without an area': surface([0, 1, 2], 0, 0, 0, 1, 0, 0, 2, 0, 0),
  'a triangle of one point': surface([0, 1, 2], 1, 1, 1, 1, 1, 1, 1, 1, 1),
  'a triangle whose corners are two points': surface([0, 1, 1], 0, 0, 0, 1, 0, 0),
  'a sheet laid twice': surface([0, 1, 2, 0, 1, 2, 2, 1, 0], 0, 0, 0, 1, 0, 0, 0, 1, 0),
  'a sheet folded flat': surface([0, 1, 2, 1, 2, 3], 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0),
  'five triangles on one edge': surface(
    [0, 1, 2, 0, 1, 3, 0, 1, 4, 0, 1, 5, 0, 1, 6],
    ...[0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0, 1, 1],
  ),
  'two sheets that touch in a point': surface(
    [0, 1, 2, 2, 3, 4],
    ...[0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 2, 0, 0, 2, 0],
  ),
  'points that no triangle has': surface([0, 1, 2], 0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 5, 5),
  'corners that are no points': surface([0, 1, 2, 0, 1, 77], 0, 0, 0, 1, 0, 0, 0, 1, 0),
  'a needle': surface([0, 1, 2, 1, 2, 3], 0, 0, 0, 1, 0, 0, 0, 1e-6, 0, 1, 1e-6, 0),
  'a mote': surface([0, 1, 2], 0, 0, 0, 1e-6, 0, 0, 0, 1e-6, 0),
};

for (const [what, geometry] of Object.entries(ODD))
  for (const fields of [
    {},
    { bendStiffness: 0.1, stretchStiffness: 1000, fixedIndex: [0], wind: [3, 0, 1] },
    { thickness: 0.2, selfCollision: true, tearStrain: 0.05, fixedIndex: [0] },
  ])
    fact(`${what}, as a cloth with ${Object.keys(fields).join() || 'nothing said'}`, async () => {
      const w = mayBeTooStiff(await world());
      addFloor(w, -1);
      const body = addBody(w, { position: [0.3, 1, 0.3], geometry: [sphere(0.3)] });
      const cloth = w.add('Cloth', { geometry, ...fields });
      goOn(w, cloth);
      below(Math.hypot(...velocity(body)), FAST, 'the ball');
    });

for (const [what, geometry] of Object.entries({
  nothing: null,
  'a single point': surface([], 0, 0, 0),
  'no triangles': surface([0, 1], 0, 0, 0, 1, 0, 0),
}))
  fact(`${what} is no cloth: it says so once, and is not there`, async () => {
    const w = await world();
    claim(w, 'bad-value');
    const cloth = w.add('Cloth', { geometry });
    w.step(5);
    close(told(w, 'bad-value').length, 1, 0);
    cloth.set('size', [1, 1]);
    w.step(5);
    close(places(cloth).length, 17 * 17, 0);
  });

fact('points that are no numbers are told, and are not there', async () => {
  const w = await world();
  claim(w, 'bad-value');
  w.add('Cloth', { geometry: surface([0, 1, 2], NaN, 0, 0, 1, 0, 0, 0, 1, 0) });
  w.step(5);
  close(codes(w).length, 2, 1);
});

fact('a million triangles are not simulated, and that is told', async () => {
  const w = await world();
  claim(w, 'bad-value');
  w.add('Cloth', { geometry: flat(708, 1, 0) });
  w.step(5);
  close(told(w, 'bad-value').length, 1, 0);
});

// ---- values that are odd ---------------------------------------------------------------------------------------------

const HUGE: Record<string, Record<string, unknown>> = {
  'bent by 1e12 N m': { bendStiffness: 1e12 },
  'sheared by 1e12 N/m': { shearStiffness: 1e12 },
  'stretched by 1e12 N/m': { stretchStiffness: 1e12 },
  'of 1e6 kg': { mass: 1e6 },
  'of a millionth of a gram': { mass: 1e-9 },
  'damped by 1e6': { damping: 1e6 },
  'a metre thick': { thickness: 1 },
  'in a wind of 50 m/s': { wind: [30, 0, 40] },
  'that tears at once': { tearStrain: 1e-9 },
};

for (const [what, fields] of Object.entries(HUGE))
  fact(`a cloth ${what} goes on`, async () => {
    const w = mayBeTooStiff(await world());
    addFloor(w, -1);
    const cloth = w.add('Cloth', {
      size: [1, 1],
      subdivision: [6, 6],
      fixedIndex: [42, 48],
      ...fields,
    });
    goOn(w, cloth);
  });

// ---- ties that jump ------------------------------------------------------------------------------------------------------

fact('pins that jump 100 m take their cloth along, and fling nothing', async () => {
  const w = mayBeTooStiff(await world());
  const cloth = w.add('Cloth', { size: [1, 1], subdivision: [6, 6], damping: 1 });
  const pins = [42, 48].map((i) => tie(w, cloth, i, { position: place(cloth, i) }));
  w.step(10);
  pins.forEach((pin, i) => pin.set('position', [100 + i, 50, -30]));
  w.step(4);
  goOn(w, cloth, 240);
  close(place(cloth, 42), [100, 50, -30], 1e-6);
});

fact('pins that are 100 m apart for a while leave a cloth that comes back', async () => {
  const w = mayBeTooStiff(await world());
  const cloth = w.add('Cloth', { size: [1, 1], subdivision: [6, 6], damping: 1, fixedIndex: [42] });
  const pin = tie(w, cloth, 48, { position: place(cloth, 48) });
  w.step(10);
  pin.set('position', [100, 0.5, 0]);
  w.step(30);
  for (const at of places(cloth)) below(Math.hypot(...at), FAR);
  pin.set('position', [0.5, 0.5, 0]);
  // It is not flung by what it was stretched: 100 m in a step would be 12 km/s.
  w.step(1);
  for (let step = 0; step < 120; step++) {
    const before = places(cloth);
    w.step();
    places(cloth).forEach((at, i) => below(distance(at, before[i]!), 30 / 120));
  }
  w.step(360);
  for (const at of places(cloth)) below(Math.hypot(...at), 2);
  goOn(w, cloth);
});

// ---- momentum ------------------------------------------------------------------------------------------------------------

fact('a ball that is tied to a cloth, or strikes one, keeps their momentum', async () => {
  for (const tied of [true, false]) {
    const w = mayBeTooStiff(await world(WEIGHTLESS));
    const cloth = w.add('Cloth', { geometry: flat(6, 1, 0), thickness: tied ? 0 : 0.02 });
    const ball = addBody(w, {
      mass: 2,
      position: [0, tied ? 0 : 0.5, 0],
      linearVelocity: [0.2, -2, 0.1],
      geometry: [sphere(0.2)],
    });
    if (tied) tie(w, cloth, 24, { body: ball });
    const momentum = (): Vec3 => {
      const { masses, velocities } = massesOf(w, cloth);
      return [0, 1, 2].map((k) =>
        masses.reduce((sum, m, i) => sum + m * velocities[3 * i + k]!, 2 * velocity(ball)[k]!),
      ) as Vec3;
    };
    w.step();
    for (let i = 0; i < 120; i++) {
      w.step();
      const off = momentum().map((p, k) => p - 2 * [0.2, -2, 0.1][k]!);
      below(Math.hypot(...off) / (2 * Math.hypot(0.2, 2, 0.1)), 1e-6, `${tied}, step ${i}`);
    }
    below(Math.hypot(...position(ball)), 10);
  }
});

/** Its points of mass as they are in the last part of a step. */
function massesOf(w: World, { id }: Node): { masses: Float64Array; velocities: Float64Array } {
  const effect = steppingOf(w).registry.find(deformables)!;
  return effect.of({ id } as never)!.material.masses;
}

fact(
  'a cloth that stretches keeps its numbers where its pins come together and crumple it',
  async () => {
    const w = await world();
    const cloth = w.add('Cloth', {
      geometry: flat([26, 10], [2.6, 1], 2),
      thickness: 0,
      damping: 1,
      stretchStiffness: 4000,
    });
    const corners = [0, 26, 270, 296];
    for (const index of corners) {
      const [x, y, z] = place(cloth, index);
      tie(w, cloth, index, { position: [x - 0.2 * Math.sign(x), y, z] });
    }
    w.advance(2);
    close(codes(w).length, 0, 0, codes(w).join());
    for (const at of places(cloth)) below(distance(at, [0, 2, 0]), 20);
  },
);
