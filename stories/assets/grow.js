/* global document, location, requestAnimationFrame, URLSearchParams */
// Scenes that grow: one more copy of a page's <template> per frame, and the numbers of the scene beside it.
import { showStats } from './stats.js';

/** Custom elements know their world; of plain X3D tags the library tells it. */
const worldOf = (element) => element.world ?? globalThis.X3DPhysics.worldOf(element);

/**
 * Has `append(copy, number)` put one copy of the template into the scene per frame, from the first step on, as often
 * as `data-count` on the x3d element or `?count=` in the address say.
 */
export async function grow(x3d, append) {
  const world = worldOf(x3d.querySelector('x3d-rigid-body, RigidBody'));
  await world.ready;
  showStats(x3d, world);
  const template = document.querySelector('template').content;
  const asked = new URLSearchParams(location.search).get('count');
  const count = Number(asked ?? x3d.dataset.count);
  let done = 0;
  const next = () => {
    if (done >= count || !x3d.isConnected) return;
    append(document.importNode(template, true), ++done, world);
    requestAnimationFrame(next);
  };
  next();
}

/** A repeatable sequence of numbers in [0, 1): every visit sees the same scene. */
export function sequence(seed = 1) {
  let state = seed;
  return () => (state = (state * 16807) % 2147483647) / 2147483647;
}
