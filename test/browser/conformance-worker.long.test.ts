import { isHere } from '../conformance/facts-here.js';
import { prove } from './conformance.js';
import { THREADS } from './threads.js';

if (THREADS.includes('worker')) prove('worker', isHere);
