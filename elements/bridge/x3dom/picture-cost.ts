import type { X3DElement } from './x3dom.js';

/** What x3dom measures of each picture, one after the other; shadows only where there are any. */
const PARTS = ['TRAVERSE', 'SORT', 'SHADOW', 'RENDER'];

/** Milliseconds of the main thread that x3dom took for its last picture. */
export function millisecondsOfPicture(x3d: Element): number {
  const measured = (x3d as X3DElement).runtime?.states?.measurements;
  let sum = 0;
  if (measured) for (const part of PARTS) sum += measured[part] ?? 0;
  return sum;
}
