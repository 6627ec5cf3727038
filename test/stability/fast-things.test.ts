import { promised } from './matrix.js';

promised('Fast things');
