// npm run lab -- effects: what each effect adds to a step and to what a page fetches. Writes lab/report/effects.json and the
// picture of docs/effects.md. dist/ must be built.
//   --draw   measure nothing: the picture of the numbers of last time
import { parseArgs } from 'node:util';
import { measureEffects, showEffects } from './run.js';

const { values: options } = parseArgs({ options: { draw: { type: 'boolean', default: false } } });

if (!options.draw) await measureEffects();
showEffects();
