import type { Ammo } from './ammo.js';
import { BODY, BROADPHASE, LEAF, PROXY } from './offsets.js';

// What Bullet's broadphase keeps of bodies: their boxes, and the lists that they stand in.

/** The list of the broadphase that a body stands in; -1: it is in no world. */
export function listOf({ HEAP32 }: Ammo, body: number): number {
  const proxy = HEAP32[(body + BODY.proxy) >> 2]!;
  return proxy === 0 ? -1 : HEAP32[(proxy + PROXY.list) >> 2]!;
}

const leafOf = ({ HEAP32 }: Ammo, body: number): number =>
  HEAP32[(HEAP32[(body + BODY.proxy) >> 2]! + PROXY.leaf) >> 2]!;

export function saveBox(ammo: Ammo, body: number, to: Float32Array, at: number): void {
  const leaf = leafOf(ammo, body);
  for (let k = 0; k < 3; k++) {
    to[at + k] = ammo.HEAPF32[(leaf + LEAF.low) / 4 + k]!;
    to[at + 3 + k] = ammo.HEAPF32[(leaf + LEAF.high) / 4 + k]!;
  }
}

/** And what the leaf hangs on holds it. */
export function loadBox(ammo: Ammo, body: number, from: Float32Array, at: number): void {
  const { HEAP32, HEAPF32 } = ammo;
  const leaf = leafOf(ammo, body);
  for (let k = 0; k < 3; k++) {
    HEAPF32[(leaf + LEAF.low) / 4 + k] = from[at + k]!;
    HEAPF32[(leaf + LEAF.high) / 4 + k] = from[at + 3 + k]!;
  }
  for (
    let node = HEAP32[(leaf + LEAF.parent) >> 2]!;
    node !== 0;
    node = HEAP32[(node + LEAF.parent) >> 2]!
  )
    for (let k = 0; k < 3; k++) {
      const low = (node + LEAF.low) / 4 + k;
      const high = (node + LEAF.high) / 4 + k;
      HEAPF32[low] = Math.min(HEAPF32[low]!, from[at + k]!);
      HEAPF32[high] = Math.max(HEAPF32[high]!, from[at + 3 + k]!);
    }
}

/** The list that takes up what moves in the next step. */
export const currentList = ({ HEAP32 }: Ammo, broadphase: number): number =>
  HEAP32[(broadphase + BROADPHASE.list) >> 2]!;

/**
 * Puts bodies into lists of the broadphase, and has all of them compared with each other in the next step. What had come to
 * rest there waits in the list that comes to rest next.
 */
export function layLists(
  { HEAP32, HEAPU8 }: Ammo,
  broadphase: number,
  current: number,
  bodies: readonly number[],
  lists: readonly number[],
): void {
  const heads = (broadphase + BROADPHASE.lists) >> 2;
  HEAP32[heads] = HEAP32[heads + 1] = 0;
  bodies.forEach((body, i) => {
    const proxy = HEAP32[(body + BODY.proxy) >> 2]!;
    const list = lists[i] === current ? current : 1 - current;
    const next = HEAP32[heads + list]!;
    HEAP32[(proxy + PROXY.before) >> 2] = 0;
    HEAP32[(proxy + PROXY.after) >> 2] = next;
    if (next !== 0) HEAP32[(next + PROXY.before) >> 2] = proxy;
    HEAP32[(proxy + PROXY.list) >> 2] = list;
    HEAP32[heads + list] = proxy;
  });
  HEAP32[(broadphase + BROADPHASE.list) >> 2] = current;
  HEAPU8[broadphase + BROADPHASE.deferred] = HEAPU8[broadphase + BROADPHASE.stale] = 1;
}
