// npm run bench: what our step and our frame cost above Bullet's own step, and whether a body costs the same in a large
// scene, in one process and interleaved.
//   --pairs <n>     pairs of runs to take the median of (15)
//   --seconds <s>   simulated seconds per run (2)
//   --scene <name>  only scenes whose name has this in it
//   --json <file>   also write the result there
// It ends with what each effect adds (lab:effects), which needs dist/.
import { writeFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { columnsOf } from './draw/table.js';
import { measureEffects, showEffects } from './effects/run.js';
import { leaveJointsToBullet } from './engines/ours.js';
import { medianInterval } from './run/bootstrap.js';
import { collect } from './run/collect.js';
import { interleaved } from './run/interleaved.js';
import { machine } from './run/machine.js';
import { median } from './run/median.js';
import { falling, scenes, started, type Scene } from './scenes.js';

const { values: options } = parseArgs({
  options: {
    pairs: { type: 'string', default: '15' },
    seconds: { type: 'string', default: '2' },
    scene: { type: 'string', default: '' },
    json: { type: 'string' },
  },
});
const PAIRS = Number(options.pairs);
const SECONDS = Number(options.seconds);

/** Frames of pages, seconds: at `standard` two steps. */
const FRAME = 1 / 60;

/** A median of the pairs, in which the machine's mood cancels, and its 95 % interval. */
interface Ratio {
  median: number;
  interval: [number, number];
}

const ratioOf = (values: readonly number[]): Ratio => ({
  median: median(values),
  interval: medianInterval(values),
});

interface Result {
  scene: string;
  bodies: number;
  joints: number;
  contacts: number;
  /** Milliseconds per step: medians. */
  ours: number;
  bullet: number;
  /** Our step to Bullet's. */
  step: Ratio;
  /** All that is ours in a frame, what is drawn between two steps included, to the Bullet steps of that frame. */
  frame: Ratio;
}

/** The same scene built three times by us; one is stepped by Bullet alone, through none of our code. */
async function pair(scene: Scene, first: number) {
  const [ours, drawn, raw] = [await started(scene), await started(scene), await started(scene)];
  const { bullet } = raw.bullet;
  // Its own rows of joints hold from here on.
  leaveJointsToBullet(raw);
  raw.step();
  const { timeStep } = ours;
  // One call is one step's share, so that all worlds have simulated as much.
  const perFrame = Math.round(FRAME / timeStep);
  let calls = 0;
  const sides = {
    ours: () => ours.step(),
    frame: () => {
      if (calls++ % perFrame === 0) drawn.frame(FRAME);
    },
    bullet: () => bullet.stepSimulation(timeStep, 0),
  };
  collect();
  const times = interleaved(sides, SECONDS / timeStep, first);
  const { bodies, joints, contacts } = ours.stats;
  for (const world of [ours, drawn, raw]) world.destroy();
  return {
    ...times,
    step: times.ours / times.bullet,
    share: times.frame / times.bullet - 1,
    bodies,
    joints,
    contacts,
  };
}

async function pairs<T>(name: string, one: (first: number) => Promise<T>): Promise<T[]> {
  const all: T[] = [];
  await one(0); // The compiler's warm-up.
  for (let i = 0; i < PAIRS; i++) {
    process.stderr.write(`\r${name}: pair ${i + 1} of ${PAIRS} `);
    all.push(await one(i));
  }
  process.stderr.write('\r\x1b[K');
  return all;
}

async function measured(scene: Scene): Promise<Result> {
  const all = await pairs(scene.name, (first) => pair(scene, first));
  const { bodies, joints, contacts } = all[0]!;
  return {
    scene: scene.name,
    bodies,
    joints,
    contacts,
    ours: median(all.map(({ ours }) => ours)),
    bullet: median(all.map(({ bullet }) => bullet)),
    step: ratioOf(all.map(({ step }) => step)),
    frame: ratioOf(all.map(({ share }) => share)),
  };
}

const SIZES = [500, 5000] as const;

/** What a falling body costs in a step, in a large scene to in a small one: with us, and by Bullet alone. */
async function perBody() {
  const [few, many] = SIZES;
  const all = await pairs(`${many} to ${few} falling boxes`, async (first) => {
    const worlds = await Promise.all(
      SIZES.flatMap((n) => [started(falling(n)), started(falling(n))]),
    );
    const [small, rawSmall, large, rawLarge] = worlds;
    const alone = (world: typeof small) => () =>
      world!.bullet.bullet.stepSimulation(world!.timeStep, 0);
    const sides = {
      small: () => small!.step(),
      large: () => large!.step(),
      rawSmall: alone(rawSmall),
      rawLarge: alone(rawLarge),
    };
    collect();
    const times = interleaved(sides, 40, first);
    for (const world of worlds) world.destroy();
    const scale = few / many;
    return {
      ours: (scale * times.large) / times.small,
      bullet: (scale * times.rawLarge) / times.rawSmall,
    };
  });
  return {
    ours: ratioOf(all.map(({ ours }) => ours)),
    bullet: ratioOf(all.map(({ bullet }) => bullet)),
  };
}

const chosen = scenes.filter(({ name }) => name.includes(options.scene));
const results: Result[] = [];
for (const scene of chosen) results.push(await measured(scene));
const bodies = options.scene ? undefined : await perBody();

const COLUMNS = ['scene', 'bodies', 'joints', 'contacts', 'ours', 'bullet'] as const;
const cell = (value: string | number) =>
  typeof value === 'number' && !Number.isInteger(value) ? value.toFixed(3) : String(value);
const shown = ({ median: middle, interval: [low, high] }: Ratio): string =>
  `${cell(middle)} (${cell(low)} – ${cell(high)})`;
console.log(`milliseconds per step, and ratios: medians of ${PAIRS} interleaved pairs (95 %)`);
const rows = [
  [...COLUMNS, 'step to Bullet’s', 'ours in a frame to Bullet’s'],
  ...results.map((result) => [
    ...COLUMNS.map((column) => cell(result[column])),
    shown(result.step),
    shown(result.frame),
  ]),
];
console.log(columnsOf(rows, 1));
if (bodies)
  console.log(
    `a falling body of ${SIZES[1]} to one of ${SIZES[0]}: ${shown(bodies.ours)}; Bullet’s ${shown(bodies.bullet)}`,
  );

const report = {
  date: new Date().toISOString(),
  machine,
  pairs: PAIRS,
  seconds: SECONDS,
  results,
  bodies,
};
if (options.json) writeFileSync(options.json, `${JSON.stringify(report, null, 2)}\n`);
console.log(JSON.stringify(report));

await measureEffects();
showEffects();
