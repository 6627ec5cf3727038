import { chunks, contacts } from '../../../physics-core/inside.js';
import { attribute, isPhysics, typeOf } from '../words/dom.js';
import { prefetchEngine } from './engine.js';

/** Begins fetching what physics elements call for, while x3dom and the rest of the page are read. */
export function prefetch(elements: Iterable<Element>): void {
  let bodies = 0;
  for (const element of elements) {
    if (!isPhysics(element)) continue;
    prefetchEngine();
    if (chunks.every(({ here }) => here)) return;
    const type = typeOf(element);
    // Worlds tell of what could not be had.
    type?.chunk?.load().catch(() => {});
    if (type?.name === 'RigidBody' && attribute(element, 'USE') === null) bodies++;
  }
  if (bodies > 1) contacts.load().catch(() => {});
}
