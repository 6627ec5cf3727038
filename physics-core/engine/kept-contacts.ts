import type { Ammo } from './ammo.js';
import { bodyAAt, bodyBAt, partsKey, partsKeyAt } from './manifold.js';
import { BODY, MANIFOLD, MANIFOLD_POINT as POINT, MOST_POINTS } from './offsets.js';

// Contact points as they stand on the heap, to the last bit: Bullet's next step begins with them.

/** Words of a manifold: the ranks of both bodies and how many points; and of a point. */
const HEAD = 3;
const WORDS = POINT.size / 4;

/** Those of a point that are numbers that somebody reads. */
const NUMBERS = [POINT.localA, POINT.localB, POINT.positionB, POINT.normalB]
  .flatMap((first) => [first / 4, first / 4 + 1, first / 4 + 2])
  .concat([POINT.distance / 4, POINT.impulse / 4]);

type Visit = (manifold: number, a: number, b: number) => void;

/** Of all manifolds that `each` visits. */
export function saveContacts({ HEAP32 }: Ammo, each: (visit: Visit) => void): Int32Array {
  let words = new Int32Array(1024);
  let used = 0;
  each((manifold, a, b) => {
    const count = HEAP32[(manifold + MANIFOLD.pointCount) >> 2]!;
    if (count === 0) return;
    const size = HEAD + count * WORDS;
    if (used + size > words.length) {
      const more = new Int32Array(2 * words.length);
      more.set(words);
      words = more;
    }
    words[used] = HEAP32[(a + BODY.rank) >> 2]!;
    words[used + 1] = HEAP32[(b + BODY.rank) >> 2]!;
    words[used + 2] = count;
    const from = (manifold + MANIFOLD.points) >> 2;
    words.set(HEAP32.subarray(from, from + count * WORDS), used + HEAD);
    used += size;
  });
  return words.slice(0, used);
}

/** Whether words are contact points of so many bodies. */
export function areContacts(words: Int32Array, bodies: number): boolean {
  const floats = new Float32Array(words.buffer, words.byteOffset, words.length);
  let at = 0;
  while (at + HEAD <= words.length) {
    const count = words[at + 2]!;
    const known = [words[at]!, words[at + 1]!].every((rank) => rank >= 0 && rank < bodies);
    if (!known || count < 1 || count > MOST_POINTS) return false;
    at += HEAD;
    for (let i = 0; i < count; i++, at += WORDS)
      if (!NUMBERS.every((word) => Number.isFinite(floats[at + word]))) return false;
  }
  return at === words.length;
}

/** Into manifolds that Bullet has made of the same pairs; what is near each other otherwise touches nowhere. */
export function loadContacts(ammo: Ammo, each: (visit: Visit) => void, words: Int32Array): void {
  const { HEAP32 } = ammo;
  const found = new Map<string, number[]>();
  each((manifold, a, b) => {
    const key = `${HEAP32[(a + BODY.rank) >> 2]} ${HEAP32[(b + BODY.rank) >> 2]}`;
    const those = found.get(key);
    if (those) those.push(manifold);
    else found.set(key, [manifold]);
  });
  const loads: [manifold: number, at: number, count: number][] = [];
  for (let at = 0; at < words.length;) {
    const count = words[at + 2]!;
    const those = found.get(`${words[at]} ${words[at + 1]}`);
    const manifold = those && takeOut(ammo, those, words, at + HEAD);
    if (manifold !== undefined) loads.push([manifold, at + HEAD, count]);
    at += HEAD + count * WORDS;
  }
  each((manifold) => (HEAP32[(manifold + MANIFOLD.pointCount) >> 2] = 0));
  for (const [manifold, at, count] of loads) {
    HEAP32.set(words.subarray(at, at + count * WORDS), (manifold + MANIFOLD.points) >> 2);
    HEAP32[(manifold + MANIFOLD.pointCount) >> 2] = count;
  }
}

/** Of several of one pair the one of the same parts. */
function takeOut(ammo: Ammo, those: number[], words: Int32Array, at: number): number | undefined {
  const [first] = those;
  if (first === undefined) return undefined;
  const index0 = words[at + POINT.index0 / 4]!;
  const index1 = words[at + POINT.index1 / 4]!;
  const key = partsKey(ammo, bodyAAt(ammo, first), bodyBAt(ammo, first), index0, index1);
  const same = those.findIndex((manifold) => partsKeyAt(ammo, manifold) === key);
  const empty = those.findIndex((manifold) => partsKeyAt(ammo, manifold) === -1);
  return same < 0 && empty < 0 ? undefined : those.splice(same >= 0 ? same : empty, 1)[0];
}
