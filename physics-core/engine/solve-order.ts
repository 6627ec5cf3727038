import { grown, grownInt } from '../base/grown.js';
import type { Ammo } from './ammo.js';
import { pointCountAt } from './manifold.js';
import { sortNearly } from './nearly-sorted.js';
import { isInParts, isOfParts, partsKeyAt } from './manifold-parts.js';
import { BODY, BROADPHASE, DISPATCHER, ISLANDS, MANIFOLD, PROXY, WORLD } from './offsets.js';

/** A body or a constraint of a world, by its pointer and the number of its node. */
interface Member {
  pointer: number;
  id: number;
}

const byId = (a: Member, b: Member): number => a.id - b.id;

/**
 * The order in which Bullet solves what it finds. Its own hangs on what came and went since the world began, and on where
 * things lie on the heap; here it follows from the numbers of nodes alone, so that a world that is restored, or made anew
 * elsewhere, goes on to the same bits.
 */
export class SolveOrder {
  readonly #ammo: Ammo;
  readonly #world: number;
  readonly #dispatcher: number;
  readonly #bodies: Member[] = [];
  readonly #constraints: Member[] = [];
  #stale = false;
  /** Whether any body is of several parts, and how many manifolds of such are set aside. */
  #inParts = false;
  #aside = 0;
  #keys = new Float64Array(64);
  #room = new Float64Array(64);
  #manifolds = new Int32Array(64);
  #roots = new Int32Array(64);
  #names = new Int32Array(64);

  constructor(ammo: Ammo, world: number, dispatcher: number) {
    this.#ammo = ammo;
    this.#world = world;
    this.#dispatcher = dispatcher;
    // Whether a pair is near each other then hangs on nothing but both boxes.
    ammo.HEAP32[(this.broadphase + BROADPHASE.cleanup) >> 2] = 100;
  }

  get broadphase(): number {
    return this.#ammo.HEAP32[(this.#world + WORLD.broadphase) >> 2]!;
  }

  // ---- who is there -------------------------------------------------------------------------------------------------

  /** A body came into the world: which of a pair is the first says its number, and not who came when. */
  addBody(pointer: number, id: number): void {
    this.#add(this.#bodies, pointer, id);
    const { HEAP32 } = this.#ammo;
    HEAP32[(HEAP32[(pointer + BODY.proxy) >> 2]! + PROXY.id) >> 2] = id;
  }

  /** Before a body comes: it is compared with others once its number is known, in the step that follows. */
  expectBody(): void {
    this.#ammo.HEAPU8[this.broadphase + BROADPHASE.deferred] = 1;
  }

  removeBody(pointer: number): void {
    this.#remove(this.#bodies, pointer);
  }

  addConstraint(pointer: number, id: number): void {
    this.#add(this.#constraints, pointer, id);
  }

  removeConstraint(pointer: number): void {
    this.#remove(this.#constraints, pointer);
  }

  #add(to: Member[], pointer: number, id: number): void {
    this.#stale = true;
    to.push({ pointer, id });
  }

  /** Those that go are mostly the last ones, or the first. */
  #remove(from: Member[], pointer: number): void {
    this.#stale = true;
    const last = from.length - 1;
    const at =
      from[last]?.pointer === pointer ? last : from.findIndex((m) => m.pointer === pointer);
    if (at >= 0) from.splice(at, 1);
  }

  // ---- before a step --------------------------------------------------------------------------------------------------

  /** Lays out Bullet's arrays of bodies and constraints. */
  arrange(): void {
    this.putBack();
    if (!this.#stale) return;
    this.#stale = false;
    this.#lay(this.#bodies, WORLD.objects);
    this.#lay(this.#constraints, WORLD.constraints);
    const { HEAP32 } = this.#ammo;
    this.#bodies.forEach(({ pointer }, rank) => (HEAP32[(pointer + BODY.rank) >> 2] = rank));
    this.#inParts = this.#bodies.some(({ pointer }) => isInParts(this.#ammo, pointer));
  }

  /** The body of a rank, as `arrange` laid them. */
  bodyAt(rank: number): number | undefined {
    return this.#bodies[rank]?.pointer;
  }

  #lay(members: Member[], array: number): void {
    members.sort(byId);
    const { HEAP32 } = this.#ammo;
    const at = HEAP32[(this.#world + array) >> 2]! >> 2;
    members.forEach(({ pointer }, i) => (HEAP32[at + i] = pointer));
  }

  // ---- in a step ------------------------------------------------------------------------------------------------------

  /** Bullet knows its islands: each has the number of its first body, whatever united them first. */
  nameIslands(): void {
    const { HEAP32, HEAPU8 } = this.#ammo;
    HEAPU8[this.broadphase + BROADPHASE.deferred] = 0;
    const islands = HEAP32[(this.#world + WORLD.islands) >> 2]!;
    const count = HEAP32[(islands + ISLANDS.count) >> 2]!;
    const at = HEAP32[(islands + ISLANDS.elements) >> 2]! >> 2;
    if (count > this.#roots.length) {
      this.#roots = grownInt(this.#roots, 2 * count);
      this.#names = grownInt(this.#names, 2 * count);
    }
    const roots = this.#roots;
    const names = this.#names.fill(-1, 0, count);
    for (let i = 0; i < count; i++) {
      let root = i;
      while (root !== HEAP32[at + 2 * root]) root = HEAP32[at + 2 * root]!;
      roots[i] = root;
      if (names[root] === -1) names[root] = i;
    }
    const objects = HEAP32[(this.#world + WORLD.objects) >> 2]! >> 2;
    for (let i = 0; i < count; i++) {
      const name = names[roots[i]!]!;
      const body = HEAP32[objects + HEAP32[at + 2 * i + 1]!]!;
      HEAP32[at + 2 * i] = HEAP32[(body + BODY.islandTag) >> 2] = name;
    }
  }

  /** Bullet knows what touches: pairs come in the order of their bodies, and those of a pair in that of its parts. */
  sortManifolds(): void {
    const { HEAP32 } = this.#ammo;
    const count = HEAP32[(this.#dispatcher + DISPATCHER.manifoldCount) >> 2]!;
    if (count < 2) return;
    const at = HEAP32[(this.#dispatcher + DISPATCHER.manifolds) >> 2]! >> 2;
    if (this.#readKeys(at, count)) return;
    const keys = this.#keys;
    sortNearly(keys, count, this.#room);
    const before = this.#manifolds;
    for (let i = 0; i < count; i++) {
      const key = keys[i]!;
      const manifold = before[key - Math.floor(key / count) * count]!;
      let to = i;
      while (
        to > 0 &&
        this.#comesBefore(manifold, key, HEAP32[at + to - 1]!, keys[to - 1]!, count)
      ) {
        this.#put(at, to, HEAP32[at + to - 1]!);
        to--;
      }
      this.#put(at, to, manifold);
    }
  }

  /**
   * Effects have found what they find. Of bodies of several parts Bullet keeps manifolds without points longer than it would
   * make them anew: until it has solved the others they are not there.
   */
  setAside(): void {
    if (!this.#inParts) return;
    const ammo = this.#ammo;
    const counter = (this.#dispatcher + DISPATCHER.manifoldCount) >> 2;
    const count = ammo.HEAP32[counter]!;
    const at = ammo.HEAP32[(this.#dispatcher + DISPATCHER.manifolds) >> 2]! >> 2;
    // It has room for all since they were sorted.
    const aside = this.#manifolds;
    let kept = 0;
    let left = 0;
    for (let i = 0; i < count; i++) {
      const manifold = ammo.HEAP32[at + i]!;
      if (pointCountAt(ammo, manifold) === 0 && isOfParts(ammo, manifold)) aside[left++] = manifold;
      else if (kept++ < i) this.#put(at, kept - 1, manifold);
    }
    for (let i = 0; i < left; i++) this.#put(at, kept + i, aside[i]!);
    ammo.HEAP32[counter] = kept;
    this.#aside = left;
  }

  putBack(): void {
    if (this.#aside === 0) return;
    this.#ammo.HEAP32[(this.#dispatcher + DISPATCHER.manifoldCount) >> 2]! += this.#aside;
    this.#aside = 0;
  }

  #put(at: number, index: number, manifold: number): void {
    const { HEAP32 } = this.#ammo;
    HEAP32[at + index] = manifold;
    HEAP32[(manifold + MANIFOLD.index) >> 2] = index;
  }

  /** Of the same pair, and of a part that comes before. */
  #comesBefore(manifold: number, key: number, other: number, otherKey: number, count: number) {
    if (key - otherKey >= count) return false;
    if (Math.floor(key / count) !== Math.floor(otherKey / count)) return false;
    return partsKeyAt(this.#ammo, manifold) < partsKeyAt(this.#ammo, other);
  }

  /** Numbers that sort as the pairs do, and tell where each stood. True: all are in order. */
  #readKeys(at: number, count: number): boolean {
    if (count > this.#keys.length) {
      this.#keys = grown(this.#keys, 2 * count);
      this.#room = new Float64Array(2 * count);
      this.#manifolds = grownInt(this.#manifolds, 2 * count);
    }
    const { HEAP32 } = this.#ammo;
    const keys = this.#keys;
    const bodies = this.#bodies.length;
    const rank = BODY.rank >> 2;
    let sorted = true;
    let last = -1;
    for (let i = 0; i < count; i++) {
      const manifold = HEAP32[at + i]!;
      const a = HEAP32[(HEAP32[(manifold + MANIFOLD.bodyA) >> 2]! >> 2) + rank]!;
      const b = HEAP32[(HEAP32[(manifold + MANIFOLD.bodyB) >> 2]! >> 2) + rank]!;
      const pair = a * bodies + b;
      keys[i] = pair * count + i;
      this.#manifolds[i] = manifold;
      // Several of one pair are looked at.
      if (pair <= last) sorted = false;
      last = pair;
    }
    return sorted;
  }
}
