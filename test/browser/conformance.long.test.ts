import { prove } from './conformance.js';

prove('main');
