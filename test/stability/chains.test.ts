import { promised } from './matrix.js';

promised('Chains and nets');
