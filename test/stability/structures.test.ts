import { promised } from './matrix.js';

promised('Structures');
