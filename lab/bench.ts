// npm run bench: what our step and our frame cost beside Bullet's own step, and whether a body costs the same in a large
// scene, in one process and interleaved. Bullet's own step is of a world that we set up, without motion states, through
// none of our code; `raw Ammo` is a program that makes the same bodies as ammo.js's examples do, with motion states.
//   --pairs <n>     pairs of runs to take the median of (15)
//   --seconds <s>   simulated seconds per run (2)
//   --scene <name>  only scenes whose name has this in it
//   --json <file>   also write the result there
// It ends with what each effect adds (`npm run lab -- effects`), which needs dist/.
import { writeFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { columnsOf } from './draw/table.js';
import { measureEffects, showEffects } from './effects/run.js';
import { ammo } from './engines/ammo.js';
import { bulletAlone, leaveJointsToBullet } from './engines/ours.js';
import { medianInterval } from './run/bootstrap.js';
import { collect } from './run/collect.js';
import { interleaved } from './run/interleaved.js';
import { machine } from './run/machine.js';
import { median } from './run/median.js';
import { falling, scenes, started, type Scene } from './scenes.js';
import type { World } from '../physics-core/inside.js';

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
  raw: number | undefined;
  /** Our step to Bullet's, and to one of raw Ammo. */
  step: Ratio;
  rawStep: Ratio | undefined;
  /** What a frame takes more than the Bullet steps of that frame, what is drawn between two steps included, to these. */
  frame: Ratio;
  /** And all of it that is our code: we leave out a stage of Bullet's step. */
  code: Ratio;
}

/** Its bodies made by hand in Ammo, stepped as ours. */
async function rawAmmo({ told, warmUp }: Scene, { timeStep, bullet }: World) {
  if (!told) return undefined;
  const { iterations } = bullet.settings;
  const made = await ammo.make(told, { step: timeStep, iterations });
  for (let i = 0; i < warmUp / timeStep; i++) made.step();
  return made;
}

/** A world that goes on by Bullet's own rows of joints. */
async function left(scene: Scene): Promise<World> {
  const world = await started(scene);
  leaveJointsToBullet(world);
  world.step();
  return world;
}

/** The same scene built four times by us, two of them stepped by none of our code, and once by hand. */
async function pair(scene: Scene, first: number) {
  const [ours, drawn] = [await started(scene), await started(scene)];
  const [alone, short] = [await left(scene), await left(scene)];
  const raw = await rawAmmo(scene, ours);
  const { timeStep } = ours;
  // One call is one step's share, so that all worlds have simulated as much.
  const perFrame = Math.round(FRAME / timeStep);
  let calls = 0;
  const sides = {
    ours: () => ours.step(),
    frame: () => {
      if (calls++ % perFrame === 0) drawn.frame(FRAME);
    },
    bullet: bulletAlone(alone),
    short: () => short.bullet.step(timeStep),
    raw: () => raw?.step(),
  };
  collect();
  const times = interleaved(sides, SECONDS / timeStep, first);
  const { bodies, joints, contacts } = ours.stats;
  for (const world of [ours, drawn, alone, short]) world.destroy();
  raw?.destroy();
  return {
    ...times,
    raw: raw && times.raw,
    step: times.ours / times.bullet,
    rawStep: raw && times.ours / times.raw,
    share: times.frame / times.bullet - 1,
    code: (times.frame - times.short) / times.bullet,
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
  const raw = all.flatMap((one) => one.raw ?? []);
  const rawStep = all.flatMap((one) => one.rawStep ?? []);
  return {
    scene: scene.name,
    bodies,
    joints,
    contacts,
    ours: median(all.map(({ ours }) => ours)),
    bullet: median(all.map(({ bullet }) => bullet)),
    raw: raw.length > 0 ? median(raw) : undefined,
    step: ratioOf(all.map(({ step }) => step)),
    rawStep: rawStep.length > 0 ? ratioOf(rawStep) : undefined,
    frame: ratioOf(all.map(({ share }) => share)),
    code: ratioOf(all.map(({ code }) => code)),
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
    const sides = {
      small: () => small!.step(),
      large: () => large!.step(),
      rawSmall: bulletAlone(rawSmall!),
      rawLarge: bulletAlone(rawLarge!),
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

const COLUMNS = ['scene', 'bodies', 'joints', 'contacts', 'ours', 'bullet', 'raw'] as const;
const cell = (value: string | number | undefined) =>
  typeof value === 'number' && !Number.isInteger(value) ? value.toFixed(3) : String(value ?? '–');
const shown = (ratio: Ratio | undefined): string => {
  if (!ratio) return '–';
  const [low, high] = ratio.interval;
  return `${cell(ratio.median)} (${cell(low)} – ${cell(high)})`;
};
console.log(`milliseconds per step, and ratios: medians of ${PAIRS} interleaved pairs (95 %)`);
const rows = [
  [
    ...COLUMNS,
    'step to Bullet’s',
    'to raw Ammo’s',
    'more in a frame to Bullet’s',
    'our code in it to Bullet’s',
  ],
  ...results.map((result) => [
    ...COLUMNS.map((column) => cell(result[column])),
    shown(result.step),
    shown(result.rawStep),
    shown(result.frame),
    shown(result.code),
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
