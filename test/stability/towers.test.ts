import { promised } from './matrix.js';

promised('Towers');
