import { promised } from './matrix.js';

promised('Mechanisms');
