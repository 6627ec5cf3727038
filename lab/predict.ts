// npm run lab -- predict: does a level cost what measureAccuracy says it will? Each scene runs at each level in turn, right
// after it was measured, several times over; what counts is the ratio.
//   --rounds <n>   rounds of every scene (5)
//   --scene <word> only those with it in their names
import { parseArgs } from 'node:util';
import { levels, type LevelName, type World } from '../physics-core/inside.js';
import { workPerMoment } from '../physics-core/accuracy/work.js';
import { median } from './run/median.js';
import { paperScenes, started, type Scene } from './scenes.js';

const { values: options } = parseArgs({
  options: { rounds: { type: 'string', default: '5' }, scene: { type: 'string', default: '' } },
});

// Milliseconds at work, not by the clock: what else the machine does is not to count.
performance.now = () => {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000;
};

const SECONDS = 1;
const FRAME = 1 / 60;

/** Agreement that is promised of the median over the scenes. */
const PROMISED = 0.25;

/** Milliseconds of work per simulated second of the running world, frame by frame as in a page. */
function running(world: World, level: LevelName): number {
  world.accuracy = level;
  const work = Array.from({ length: SECONDS / FRAME }, () => {
    const start = performance.now();
    world.frame(FRAME);
    return performance.now() - start;
  });
  return workPerMoment(work) / FRAME;
}

/** Predicted / measured, by level. */
async function round(scene: Scene): Promise<number[]> {
  const world = await started(scene);
  const predicted = await world.measureAccuracy({ seconds: SECONDS });
  const before = world.snapshot();
  const ratios = predicted.map(({ level, msPerSecond }) => {
    world.restore(before);
    return msPerSecond / running(world, level);
  });
  world.destroy();
  return ratios;
}

const scenes = paperScenes.filter(({ name }) => name.includes(options.scene));
const all = new Map<Scene, number[][]>(scenes.map((scene) => [scene, []]));
for (let i = 0; i < Number(options.rounds); i++)
  for (const scene of scenes) {
    process.stderr.write(`\rround ${i + 1}: ${scene.name}          `);
    all.get(scene)!.push(await round(scene));
  }
process.stderr.write('\r\x1b[K');

const show = (name: string, ratios: number[]): void =>
  console.log(name.padEnd(22), ...ratios.map((ratio) => ratio.toFixed(2).padStart(9)));
console.log('predicted / measured milliseconds per simulated second, medians');
console.log(''.padEnd(22), ...levels.map(({ name }) => name.padStart(9)));
const byScene = [...all].map(([{ name }, rounds]) => {
  const ratios = levels.map((_, i) => median(rounds.map((each) => each[i]!)));
  show(name, ratios);
  return ratios;
});
const off = levels.map((_, i) => median(byScene.map((ratios) => Math.abs(ratios[i]! - 1))));
show('off by, median', off);
const kept = off.every((each) => each <= PROMISED);
console.log(`${kept ? 'within' : 'NOT within'} the ${PROMISED * 100} % promised at every level`);
process.exitCode = kept ? 0 : 1;
