import { promised } from './matrix.js';

promised('Hard values');
