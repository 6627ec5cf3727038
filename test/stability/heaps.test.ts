import { promised } from './matrix.js';

promised('Heaps');
