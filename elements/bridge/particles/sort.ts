import type { Seen } from './seen.js';

/** Layers of depth that are told apart: more than a picture has lines. */
const LAYERS = 4096;

const counts = new Uint32Array(LAYERS + 1);
let layers = new Uint16Array(0);

/**
 * Orders particles by how far they are from who looks, the farthest first: sorted by counting, since thousands are in
 * every frame. `view`: right, up and back of who looks.
 */
export function farthestFirst({ places, count, order, low, high }: Seen, view: Float64Array): void {
  if (layers.length < count) layers = new Uint16Array(2 * count);
  const [x, y, z] = [view[6]!, view[7]!, view[8]!];
  // Backwards is towards who looks: the least is the farthest. No particle is beyond the box of all.
  let least = 0;
  let most = 0;
  for (let axis = 0; axis < 3; axis++) {
    const a = view[6 + axis]! * low[axis]!;
    const b = view[6 + axis]! * high[axis]!;
    least += Math.min(a, b);
    most += Math.max(a, b);
  }
  const scale = most > least ? (LAYERS - 1) / (most - least) : 0;
  counts.fill(0);
  for (let k = 0, at = 0; k < count; k++, at += 3) {
    const depth = x * places[at]! + y * places[at + 1]! + z * places[at + 2]!;
    const layer = ((depth - least) * scale) | 0;
    layers[k] = layer;
    counts[layer + 1]!++;
  }
  for (let layer = 0; layer < LAYERS; layer++) counts[layer + 1]! += counts[layer]!;
  for (let k = 0; k < count; k++) order[counts[layers[k]!]!++] = k;
}
