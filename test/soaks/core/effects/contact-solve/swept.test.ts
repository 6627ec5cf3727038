import type { World } from '../../../../../physics-core/inside.js';
import {
  addBody,
  addFloor,
  below,
  box,
  fact,
  position,
  world,
  type Body,
} from '../../../../core/helpers.js';

// Contacts of more than 200 slow bodies are gone over one at a time, and contradict each other by some hundredths of a
// millimetre: what is off by no more goes on bearing as it lies.

/** Columns of two boxes on one board: all hang together by it. */
async function columns(): Promise<{ w: World; tops: Body[] }> {
  const w = await world({ gravity: [0, -9.8, 0] });
  addFloor(w);
  addBody(w, { position: [0, 0.25, 0], mass: 1000, geometry: [box(18, 0.5, 18)] });
  const tops: Body[] = [];
  for (let x = -7; x <= 7; x++)
    for (let z = -7; z <= 7; z++) {
      addBody(w, { position: [1.1 * x, 1, 1.1 * z], geometry: [box(1, 1, 1)] });
      tops.push(addBody(w, { position: [1.1 * x, 2, 1.1 * z], geometry: [box(1, 1, 1)] }));
    }
  w.advance(1);
  return { w, tops };
}

/** Height of a box half a second after it was lifted, against where it lay, metres. */
function staysAt(w: World, body: Body, lift: number): number {
  const [x, y, z] = position(body);
  body.set('position', [x, y + lift, z]);
  w.advance(0.5);
  return position(body)[1] - y;
}

/** What was built to touch lies so far above the depth that contacts keep, metres. */
const BUILT = 4e-6;

for (const [lift, stays, what] of [
  [2e-5, 2e-5, 'is lifted by .02 mm stays there'],
  [-2e-5, -2e-5, 'is pressed in by .02 mm stays there'],
  [1e-4, 3e-5 - BUILT, 'is lifted by .1 mm sinks to .03 above the depth that contacts keep'],
] as const)
  fact(`what lies in a heap of hundreds and ${what}`, async () => {
    const { w, tops } = await columns();
    below(Math.abs(staysAt(w, tops[100]!, lift) - stays), 2e-6, 'm');
  });
