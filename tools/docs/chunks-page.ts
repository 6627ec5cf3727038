// npm run write -- chunks: writes docs/chunks.md anew, from what was built.
import { writeFileSync } from 'node:fs';
import { chunksPage, PAGE } from './effects/chunks.js';

writeFileSync(PAGE, chunksPage());
