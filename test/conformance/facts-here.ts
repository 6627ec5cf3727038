import type { Fact } from './fact.js';

// Facts that are not run with a worker, by why: all others that pages run are. Of a node, or of one of its fields.
const HERE: Record<string, readonly string[]> = {
  'contacts come from when they are first asked for, and the first list that page code hands over brings its world back':
    ['Contact', 'CollisionSensor.contacts', 'RigidBodyCollection.set_contacts'],
  'frames are what it stops; steps that are asked for by hand are taken all the same': [
    'RigidBodyCollection.enabled',
  ],
};

const names: ReadonlySet<string> = new Set(Object.values(HERE).flat());

/** What says nothing about motion says nothing of threads, and takes two workers. */
export const isHere = (type: string, { field, inert }: Fact): boolean =>
  !!inert || names.has(type) || names.has(`${type}.${field}`);
