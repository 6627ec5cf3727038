// Bundled for the pages that are measured.
import { changes } from './changes.js';
import { room } from './room.js';
import { turns } from './turns.js';

const measure = { changes, room, turns };
export type Measure = typeof measure;
Object.assign(window, { measure });
