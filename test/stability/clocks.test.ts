import { promised } from './matrix.js';

promised('Clocks');
