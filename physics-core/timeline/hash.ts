import { POSE } from '../dynamics/poses.js';
import type { World } from '../world/world.js';

/** FNV-1a, of words instead of bytes: http://www.isthe.com/chongo/tech/comp/fnv/ */
const BASIS = 0x811c9dc5;
const PRIME = 0x01000193;

/** Of where all bodies of a world are and how fast, to the bit: 8 hexadecimal digits. */
export function hashOf({ bodies, poses }: World): string {
  const words = new Int32Array(2 * POSE);
  const numbers = new Float64Array(words.buffer);
  let hash = BASIS;
  const take = (from: Float64Array, at: number, count: number): void => {
    for (let i = 0; i < count; i++) numbers[i] = from[at + i]!;
    for (let i = 0; i < 2 * count; i++) hash = Math.imul(hash ^ words[i]!, PRIME);
  };
  for (const body of [...bodies].sort((a, b) => a.id - b.id)) {
    take(poses.current, POSE * body.slot, POSE);
    take(bodies.velocityOf(body), 0, 6);
  }
  return (hash >>> 0).toString(16).padStart(8, '0');
}
