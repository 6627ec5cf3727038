import { PARTICLE } from '../../../physics-core/particles.js';

/** Layers of depth that are told apart: more than a picture has lines. */
const LAYERS = 4096;

const counts = new Uint32Array(LAYERS + 1);
let layers = new Uint16Array(0);
let depths = new Float32Array(0);
let order = new Uint32Array(0);

/** Particles by how far they are from who looks, the farthest first: sorted by counting, since thousands are in every frame. */
export function farthestFirst(
  motion: Float64Array,
  first: number,
  count: number,
  view: Float64Array,
): Uint32Array {
  if (order.length < count) {
    order = new Uint32Array(2 * count);
    layers = new Uint16Array(2 * count);
    depths = new Float32Array(2 * count);
  }
  let least = Infinity;
  let most = -Infinity;
  for (let k = 0; k < count; k++) {
    const at = (first + k) * PARTICLE;
    const depth = view[6]! * motion[at]! + view[7]! * motion[at + 1]! + view[8]! * motion[at + 2]!;
    depths[k] = depth;
    if (depth < least) least = depth;
    if (depth > most) most = depth;
  }
  const scale = most > least ? (LAYERS - 1) / (most - least) : 0;
  counts.fill(0);
  for (let k = 0; k < count; k++) {
    // Backwards is towards who looks: the least is the farthest.
    const layer = Math.max(0, Math.floor((depths[k]! - least) * scale));
    layers[k] = layer;
    counts[layer + 1]!++;
  }
  for (let layer = 0; layer < LAYERS; layer++) counts[layer + 1]! += counts[layer]!;
  for (let k = 0; k < count; k++) order[counts[layers[k]!]!++] = first + k;
  return order;
}
