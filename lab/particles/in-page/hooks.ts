// The first script of each page of particles.
import { begin, libraryHere } from '../../page/in-page/bench.js';
import { adapters } from './adapters.js';

begin(adapters[libraryHere()]!);
