// npm run write -- effects: writes docs/effects.md anew.
import { writeFileSync } from 'node:fs';
import { effectsPage, PAGE } from './effects/page.js';

writeFileSync(PAGE, await effectsPage());
