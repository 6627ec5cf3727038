import { chainSag } from '../../../../references/hanging-chain.js';
import { close, fact, world, type Vec3 } from '../../helpers.js';
import { addRope, LEVELS, place, places } from './helpers.js';

const SPAN = 1.2;

/** Two straight legs of 20 links each, between two points of one height. */
const legs: Vec3[] = Array.from({ length: 41 }, (_, i): Vec3 => [
  (SPAN * i) / 40,
  -0.8 * (1 - Math.abs(i / 20 - 1)),
  0,
]);

for (const accuracy of LEVELS)
  fact(`between two ends it hangs as the chain of its links does, at ${accuracy}`, async () => {
    const w = await world({ accuracy });
    const rope = addRope(w, legs, { fixedIndex: [0, 40], damping: 2 });
    w.advance(16);
    close(-place(rope, 20)[1], chainSag(40, 2, SPAN), 5e-5, accuracy);
    places(rope).forEach(([x, y], i) =>
      close([x, y], [SPAN - place(rope, 40 - i)[0], place(rope, 40 - i)[1]], 5e-5),
    );
  });
