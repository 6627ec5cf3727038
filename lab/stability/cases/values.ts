import type { World } from '../../../physics-core/inside.js';
import type { StabilityCase } from '../case.js';
import {
  addBody,
  addFloor,
  atTheEnd,
  box,
  distance,
  greatest,
  height,
  most,
  position,
  type Body,
} from '../scene.js';

// Values that break engines: sizes, places and numbers.

const OFF = { what: 'off its place of rest', unit: 'm' };

/** The body that was hurt, and one beside it that nothing happens to. */
const resting = (w: World, body: Body, at: number): (() => number) => {
  addFloor(w);
  const other = addBody(w, { position: [9, 0.5, 0], geometry: [box(1)] });
  return () => most([Math.abs(height(body) - at), Math.abs(height(other) - 0.5)]);
};

const geometry = (
  id: string,
  says: string,
  shapes: object[],
  more: Pick<StabilityCase, 'tells' | 'mayTell'> & {
    at?: number;
    within?: number;
    promisedFrom?: null;
  },
): StabilityCase => ({
  id,
  says,
  seconds: 3,
  criterion: { ...OFF, most: more.within ?? 5e-3 },
  promisedFrom: 'game',
  ...more,
  scene: (w) =>
    atTheEnd(resting(w, addBody(w, { position: [0, 0.7, 0], geometry: shapes }), more.at ?? 0.5)),
});

const faces = (coord: number[], coordIndex: number[]) => ({
  type: 'IndexedFaceSet',
  coord,
  coordIndex,
});

/** How far a stone is from where it was put on a slab there. */
const farStone = (id: string, far: number): StabilityCase => ({
  id,
  says: `a box comes to rest ${far / 1000} km from the origin`,
  load: { of: 'metres from the origin', ratio: far },
  seconds: 5,
  criterion: { ...OFF, most: 0.001 },
  promisedFrom: 'game',
  scene(w) {
    addBody(w, { fixed: true, position: [far, -0.5, 0], geometry: [box(60, 1, 60)] });
    const stone = addBody(w, { position: [far, 1, 0], geometry: [box(1)] });
    return atTheEnd(() => distance(position(stone), [far, 0.5, 0]));
  },
});

const sized = (id: string, says: string, size: number, mass: number): StabilityCase => ({
  id,
  says,
  load: { of: 'metres', ratio: size },
  seconds: 5,
  criterion: { what: 'off its place of rest, of its size', unit: '', most: 0.1 },
  promisedFrom: 'game',
  scene(w) {
    addBody(w, {
      fixed: true,
      position: [0, -5000, 0],
      geometry: [box(1e5, 1e4, 1e5)],
    });
    const body = addBody(w, { position: [0, size * 0.5005, 0], mass, geometry: [box(size)] });
    return atTheEnd(() => Math.abs(height(body) - size / 2) / size);
  },
});

const poisons: [field: string, value: unknown][] = [
  ['linearVelocity', [0, NaN, 0]],
  ['angularVelocity', [Infinity, 0, 0]],
  ['position', [NaN, 0, 0]],
  ['mass', NaN],
  ['forces', [[0, NaN, 0]]],
];

export const values: StabilityCase[] = [
  geometry('S13 flat', 'a box of no height rests on the floor', [box(1, 0, 1)], {
    tells: ['zero-volume'],
    at: 0,
  }),
  geometry('S13 point', 'a box of no size rests on the floor', [box(0)], {
    tells: ['zero-volume'],
    at: 0,
  }),
  geometry(
    'S13 negative',
    'a box of negative size is told of, and hurts nobody',
    [box(1), box(-1, 1, 1)],
    {
      tells: ['zero-volume'],
    },
  ),
  geometry(
    'S14 NaN',
    'an extent that is no number never reaches Bullet',
    [box(1), box(NaN, 1, 1)],
    {
      tells: ['bad-value'],
    },
  ),
  geometry(
    'S14 infinite',
    'an infinite extent never reaches Bullet',
    [box(1), box(1, Infinity, 1)],
    {
      tells: ['bad-value'],
    },
  ),
  sized('S16 1 mm', 'a box of a millimetre rests on the floor', 1e-3, 1e-6),
  sized('S16 1 cm', 'a box of a centimetre rests on the floor', 1e-2, 1e-3),
  sized('S16 10 km', 'a box of ten kilometres rests on the floor', 1e4, 1e9),
  farStone('S17 1 km', 1e3),
  farStone('S17 100 km', 1e5),
  farStone('S17 1000 km', 1e6),
  {
    id: 'S17 moving',
    says: 'a ball that flies 1000 km from the origin flies its parabola',
    load: { of: 'metres from the origin', ratio: 1e6 },
    seconds: 2,
    criterion: { what: 'off the parabola', unit: 'm', most: 3e-4 },
    promisedFrom: 'game',
    scene(w) {
      const ball = addBody(w, { position: [1e6, 1e6, 0], linearVelocity: [3, 10, 0] });
      let found = 0;
      return {
        after: () => {
          const t = w.time;
          const there = [1e6 + 3 * t, 1e6 + 10 * t - 4.9 * t * t, 0];
          found = Math.max(found, distance(position(ball), there));
        },
        measured: () => found,
      };
    },
  },
  geometry(
    'S18 coplanar',
    'a hull of four points in a plane rests on the floor',
    [faces([-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1], [0, 1, 2, 3, -1])],
    { mayTell: ['zero-volume'], at: 0, within: 0.01 },
  ),
  geometry(
    'S18 needle',
    'a hull that is nearly a line rests on the floor',
    [faces([-1, 0, 0, 1, 0, 0, 0, 1e-5, 1e-5], [0, 1, 2, -1])],
    { mayTell: ['zero-volume'], at: 0, within: 0.01 },
  ),
  geometry('S18 empty', 'a hull without points is no part of a body', [box(1), faces([], [])], {
    mayTell: ['zero-volume', 'bad-value'],
  }),
  {
    id: 'S23',
    says: 'a body with a moment of zero is refused it, and rests',
    seconds: 3,
    criterion: { ...OFF, most: 5e-3 },
    promisedFrom: 'game',
    tells: ['out-of-range'],
    scene(w) {
      const body = addBody(w, {
        position: [0, 1, 0],
        geometry: [box(1)],
        inertia: [0, 0, 0, 0, 1, 0, 0, 0, 1],
      });
      return atTheEnd(resting(w, body, 0.5));
    },
  },
  {
    id: 'S25',
    says: 'velocity, place, mass, force and gravity that are no number hurt nobody',
    seconds: 3,
    // Each step rounds a place 99 m up by up to half an ulp: up to 11 mm at `reference`, where it strays by 6.
    criterion: { what: 'off fall and place, beyond rounding', unit: 'm', most: 1e-3 },
    promisedFrom: 'game',
    tells: ['bad-value'],
    scene(w) {
      const floor = addFloor(w);
      const stack = [0, 1, 2].map((i) =>
        addBody(w, { position: [0, 0.5 + i, 0], geometry: [box(1)] }),
      );
      const flying = addBody(w, { position: [9, 99, 0] });
      const HALF_ULP = 2 ** -18;
      let rounding = 0;
      return greatest(
        () => {
          rounding += HALF_ULP;
          const fall = Math.abs(height(flying) - 99 + 4.9 * w.time ** 2) - rounding;
          const stand = most(stack.map((body, i) => Math.abs(height(body) - 0.5 - i)));
          return most([Math.abs(height(floor) + 0.5), fall, stand]);
        },
        {
          before: (_, frame) => {
            const [field, value] = poisons[frame % poisons.length]!;
            stack[1]!.set(field, value);
            flying.set(field, value);
            w.set('gravity', [0, NaN, 0]);
          },
        },
      );
    },
  },
  {
    id: 'S26',
    says: 'a clock that stands still, goes back or has no number takes no time',
    seconds: 2,
    criterion: { what: 'off the fall that it ought to have', unit: 'm', most: 1e-3 },
    promisedFrom: 'game',
    mayTell: ['bad-value'],
    lowest: -20,
    scene(w) {
      const ball = addBody(w);
      return greatest(() => Math.abs(height(ball) + 4.9 * w.time ** 2), {
        pass: () => {
          for (const seconds of [0, -1, NaN, -Infinity, 1e-9]) w.frame(seconds);
          w.step(NaN);
          w.step(-3);
          w.frame(1 / 60);
        },
      });
    },
  },
  {
    id: 'overflow',
    says: 'a kick that would overflow is refused, and the stack stands',
    seconds: 3,
    criterion: { what: 'farthest from its place', unit: 'm', most: 2e-3 },
    promisedFrom: 'game',
    work: 'it is kicked',
    tells: ['bad-value'],
    scene(w) {
      addFloor(w);
      const stack = [0, 1, 2].map((i) =>
        addBody(w, { mass: i < 2 ? 1 : 0.1, position: [0, 0.5 + i, 0], geometry: [box(1)] }),
      );
      const before = stack.map(position);
      return greatest(() => most(stack.map((body, i) => distance(position(body), before[i]!))), {
        // It would make 1e39 m/s, infinite in single precision.
        before: (_, frame) => {
          if (frame === 60) stack[2]!.applyImpulse([1e38, 0, 0]);
        },
      });
    },
  },
];
