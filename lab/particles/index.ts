// npm run lab -- particles: what ten thousand particles cost: a step in Node, and a frame's script in pages of Chromium,
// beside X_ITE and Babylon.js. Writes lab/report/particles.json, docs/particles-price.md and its picture. dist/ must be
// built; no network is needed.
//   --quick   whether all of it runs: few particles, few turns; nothing is kept
//   --draw    measure nothing: page and picture of the numbers of last time
import { parseArgs } from 'node:util';
import { columnsOf, type Table } from '../draw/table.js';
import { progress } from '../run/progress.js';
import { drawParticles } from './draw.js';
import { libraries, versionOf } from './libraries.js';
import { measureInChromium, measureInNode, missingIn, QUICK, THOROUGH } from './measure.js';
import { readParticles, writeParticles, type ParticleNumbers } from './numbers.js';
import { nodeTable, pageTable } from './tables.js';

const { values: options } = parseArgs({
  options: {
    quick: { type: 'boolean', default: false },
    draw: { type: 'boolean', default: false },
  },
});

function show(title: string, { head, rows }: Table): void {
  progress('');
  console.log(`\n${title}\n${columnsOf([head, ...rows], 1)}`);
}

async function measure(): Promise<ParticleNumbers> {
  const plan = options.quick ? QUICK : THOROUGH;
  const node = await measureInNode(plan, progress);
  show(`${plan.count} particles, a step in Node`, nodeTable({ node }));
  const chromium = await measureInChromium(plan, progress);
  show(`${plan.count} particles, a frame in Chromium`, pageTable({ chromium }));
  const { count, turns, each } = plan;
  const versions = Object.fromEntries(libraries.map((one) => [one.id, versionOf(one)]));
  return { versions, count, turns, each, node, chromium };
}

if (!options.draw) {
  const numbers = await measure();
  const missing = missingIn(numbers);
  const rows = numbers.node.rows.length + numbers.chromium.rows.length;
  console.log(`\n${rows} rows measured, ${missing.length} not`);
  for (const one of missing) console.log(one);
  if (missing.length > 0) process.exitCode = 1;
  else if (!options.quick) writeParticles(numbers);
}
if (!options.quick && !process.exitCode) drawParticles(readParticles());
// A browser that was opened may take a while to go.
process.exit();
