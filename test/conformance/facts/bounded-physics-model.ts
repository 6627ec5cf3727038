import { near } from '../checks.js';
import type { Driver, Fact, NodeData } from '../fact.js';
import { box } from '../scenes.js';
import { EXACT, places, point, system } from './particle-scenes.js';

const READING = 'it throws them back as fast as they came, from either side';

/** Particles without a width, thrown along X at 2 m/s. */
const thrown = (fields = {}, emitter = {}): NodeData[] =>
  system(point({ speed: 2, ...emitter }), {
    particleSize: [0, 0],
    physics: [{ type: 'BoundedPhysicsModel', DEF: 'model', geometry: box(2), ...fields }],
  });

/** Where a point is that goes to and fro between -`wall` and `wall`, after such a way from the middle. */
const between = (wall: number, way: number): number => {
  const turn = (way + wall) % (4 * wall);
  return (turn < 2 * wall ? turn : 4 * wall - turn) - wall;
};

const oldest = async (x: Driver): Promise<number[]> => (await places(x))[0]!;

const geometry: Fact[] = [
  {
    field: 'geometry',
    says: 'keeps what is within: it goes to and fro between two faces',
    open: READING,
    scene: thrown(),
    run: async (x) => {
      const checks = [];
      let now = 0;
      for (const seconds of [0.55, 1.25, 3.05]) {
        await x.advance(seconds - now);
        now = seconds;
        const expected = [between(1, 2 * seconds), 0, 0];
        checks.push(near(`after ${seconds} s`, await oldest(x), expected, EXACT, 'm'));
      }
      return checks;
    },
  },
  {
    field: 'geometry',
    says: 'throws back what comes from outside, like light off a mirror',
    open: READING,
    // Against the face that looks along -X, at 3 and 4 m/s.
    scene: thrown({}, { position: [-3, -2.5, 0], direction: [3, 4, 0], speed: 5 }),
    run: async (x) => {
      await x.advance(0.95);
      // After 2/3 s it is at (-1, 1/6).
      const expected = [-1 - 3 * (0.95 - 2 / 3), -2.5 + 4 * 0.95, 0];
      return [near('the oldest', await oldest(x), expected, EXACT, 'm')];
    },
  },
  {
    field: 'geometry',
    says: 'is replaced by an event: the new one holds them',
    open: READING,
    scene: thrown(),
    run: async (x) => {
      await x.advance(0.25);
      await x.set('model', 'geometry', box(4));
      await x.advance(1);
      return [near('after 1.25 s', await oldest(x), [between(2, 2.5), 0, 0], EXACT, 'm')];
    },
  },
];

const enabled: Fact = {
  field: 'enabled',
  says: 'FALSE lets them through; TRUE, from an event on, does not',
  open: READING,
  scene: thrown({ enabled: false, geometry: box(4) }, { speed: 2 }),
  run: async (x) => {
    await x.advance(1.25);
    const free = await oldest(x);
    await x.set('model', 'enabled', true);
    await x.advance(0.6);
    const all = (await places(x)).map(([at]) => at!);
    // Born after 1 s, it meets the wall a second later.
    const first = all[10]!;
    await x.advance(0.5);
    const last = (await places(x))[10]![0]!;
    return [
      near('through', free, [2.5, 0, 0], EXACT, 'm'),
      near('a later one', [first, last], [1.7, between(2, 2.7)], EXACT, 'm'),
    ];
  },
};

export const boundedPhysicsModel: Fact[] = [...geometry, enabled];
