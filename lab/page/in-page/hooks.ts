// The first script of each measured page.
import { adapters } from './adapters.js';
import { begin, libraryHere } from './bench.js';

begin(adapters[libraryHere()]!);
