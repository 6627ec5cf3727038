// npm run bench: what our step costs above Bullet's own, on the paper's scenes, in one process and interleaved.
//   --pairs <n>     pairs of runs to take the median of (9)
//   --seconds <s>   simulated seconds per run (2)
//   --json <file>   also write the result there
// It ends with what each effect adds (lab:effects), which needs dist/.
import { writeFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { columnsOf } from './draw/table.js';
import { measureEffects, showEffects } from './effects/run.js';
import { leaveJointsToBullet } from './engines/ours.js';
import { machine } from './run/machine.js';
import { median } from './run/median.js';
import { scenes, started, type Scene } from './scenes.js';

const { values: options } = parseArgs({
  options: {
    pairs: { type: 'string', default: '9' },
    seconds: { type: 'string', default: '2' },
    json: { type: 'string' },
  },
});
const PAIRS = Number(options.pairs);
const SECONDS = Number(options.seconds);

interface Result {
  scene: string;
  bodies: number;
  joints: number;
  contacts: number;
  /** Milliseconds of work per simulated second: medians. */
  ours: number;
  bullet: number;
  /** Median of ours / bullet of each pair: the machine's mood cancels. */
  ratio: number;
  /** Least and greatest ratio of a pair. */
  spread: [number, number];
}

/** Steps that one side takes before the other has its turn: short, so that the machine's mood hits both alike. */
const TURN = 10;

/** The same scene built twice by us; the second is stepped by Bullet alone, through none of our code. */
async function pair(scene: Scene, oursFirst: boolean) {
  const [ours, raw] = [await started(scene), await started(scene)];
  const { bullet } = raw.bullet;
  // Its own rows of joints hold from here on.
  leaveJointsToBullet(raw);
  raw.step();
  const step = {
    ours: () => ours.step(),
    bullet: () => bullet.stepSimulation(raw.timeStep, 0),
  };
  const order = oursFirst ? (['ours', 'bullet'] as const) : (['bullet', 'ours'] as const);
  const times = { ours: 0, bullet: 0 };
  const turns = Math.round(SECONDS / ours.timeStep / TURN);
  for (let turn = 0; turn < turns; turn++) {
    for (const name of order) {
      const start = performance.now();
      for (let i = 0; i < TURN; i++) step[name]();
      times[name] += (performance.now() - start) / (turns * TURN * ours.timeStep);
    }
  }
  const { bodies, joints, contacts } = ours.stats;
  ours.destroy();
  raw.destroy();
  return { ...times, bodies, joints, contacts };
}

async function measured(scene: Scene): Promise<Result> {
  const pairs: Awaited<ReturnType<typeof pair>>[] = [];
  await pair(scene, true); // The compiler's warm-up.
  for (let i = 0; i < PAIRS; i++) {
    process.stderr.write(`\r${scene.name}: pair ${i + 1} of ${PAIRS} `);
    pairs.push(await pair(scene, i % 2 === 0));
  }
  process.stderr.write('\r\x1b[K');
  const ratios = pairs.map(({ ours, bullet }) => ours / bullet);
  const { bodies, joints, contacts } = pairs[0]!;
  return {
    scene: scene.name,
    bodies,
    joints,
    contacts,
    ours: median(pairs.map(({ ours }) => ours)),
    bullet: median(pairs.map(({ bullet }) => bullet)),
    ratio: median(ratios),
    spread: [Math.min(...ratios), Math.max(...ratios)],
  };
}

const results: Result[] = [];
for (const scene of scenes) results.push(await measured(scene));

const columns = ['scene', 'bodies', 'joints', 'contacts', 'ours', 'bullet', 'ratio'] as const;
console.log(`milliseconds per simulated second, median of ${PAIRS} interleaved pairs`);
const cell = (value: string | number) =>
  typeof value === 'number' && !Number.isInteger(value) ? value.toFixed(2) : String(value);
const rows = [
  [...columns, 'spread'],
  ...results.map((result) => [
    ...columns.map((column) => cell(result[column])),
    result.spread.map(cell).join(' – '),
  ]),
];
console.log(columnsOf(rows, 1));

const report = { date: new Date().toISOString(), machine, pairs: PAIRS, seconds: SECONDS, results };
if (options.json) writeFileSync(options.json, `${JSON.stringify(report, null, 2)}\n`);
console.log(JSON.stringify(report));

await measureEffects();
showEffects();
