import { configure } from '../../physics-core/inside.js';

// A worker runs one file, and that is the build's.
configure({ workerUrl: '/dist/x3d-physics.classic.js' });

/** Where the steps of a world are taken. */
export type Thread = 'main' | 'worker';

/** Those that facts of a page are told of; a worker is nothing that browsers differ in. */
export const THREADS: readonly Thread[] = 'chrome' in window ? ['main', 'worker'] : ['main'];

/** Behind the name of a fact. */
export const on = (thread: Thread): string => (thread === 'main' ? '' : ', in a worker');
