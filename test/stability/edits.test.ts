import { promised } from './matrix.js';

promised('Edits');
