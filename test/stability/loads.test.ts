import { promised } from './matrix.js';

promised('Loads');
