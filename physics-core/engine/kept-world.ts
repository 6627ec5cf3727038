import type { BulletWorld } from './bullet-world.js';
import type { BtBody } from './heap.js';
import { BODY } from './offsets.js';
import { keepAwake } from './body-state.js';
import { currentList, layLists, listOf, loadBox, saveBox } from './kept-boxes.js';
import { areContacts, eachLost, loadContacts, saveContacts } from './kept-contacts.js';

/** How much nearer parts come that Bullet does not see near each other, metres, and how often. */
const NEARER = 0.04;
const MOST_ROUNDS = 6;

/** A body that stands in the world, whose box is one of `boxes`. */
interface Standing {
  readonly body: BtBody;
  readonly pointer: number;
  readonly movable: boolean;
  readonly solidParts: readonly unknown[];
}

/** What a world goes back to: boxes by bodies, contact points, and the list that the next step fills. */
interface Moment {
  boxes: Float32Array;
  at: readonly number[];
  contacts: Int32Array;
  list: number;
}

/** What Bullet keeps of its world from step to step beside bodies: which of them are near each other, and where they touch. */
export class KeptWorld {
  readonly #bullet: BulletWorld;
  readonly #broadphase: number;

  constructor(bullet: BulletWorld, broadphase: number) {
    this.#bullet = bullet;
    this.#broadphase = broadphase;
  }

  get #ammo(): BulletWorld['engine']['ammo'] {
    return this.#bullet.engine.ammo;
  }

  get list(): number {
    return currentList(this.#ammo, this.#broadphase);
  }

  listOf(body: number): number {
    return listOf(this.#ammo, body);
  }

  saveBox(body: number, to: Float32Array, at: number): void {
    saveBox(this.#ammo, body, to, at);
  }

  saveContacts(): Int32Array {
    this.#bullet.order!.arrange();
    this.#bullet.order!.sortManifolds();
    return saveContacts(this.#ammo, (visit) => this.#bullet.eachPair(visit));
  }

  /** Whether points in touch are such, of so many bodies; none at all are those of a world without the code of contacts. */
  areContacts(kept: Int32Array, bodies: number): boolean {
    return kept.length === 0 || areContacts(kept, bodies);
  }

  /** Bodies stand where they did; those that sleep are woken. */
  goBack(bodies: readonly Standing[], lists: readonly number[], moment: Moment): void {
    const ammo = this.#ammo;
    for (const { body, movable } of bodies) if (movable) keepAwake(body);
    this.#bullet.order!.arrange();
    // Whoever was near whom, all are compared with each other.
    this.#bullet.order!.expectBody();
    this.#bullet.findPairs();
    if (bodies.some(({ solidParts }) => solidParts.length > 1)) this.#findParts(moment.contacts);
    loadContacts(ammo, (visit) => this.#bullet.eachPair(visit), moment.contacts);
    bodies.forEach(({ pointer }, i) => loadBox(ammo, pointer, moment.boxes, moment.at[i]!));
    const pointers = bodies.map(({ pointer }) => pointer);
    layLists(ammo, this.#broadphase, moment.list, pointers, lists);
  }

  /** Bodies of several parts come a little nearer to what they touched, until Bullet has seen it. */
  #findParts(contacts: Int32Array): void {
    for (let round = 0; round < MOST_ROUNDS; round++) {
      const moved = new Map<number, () => void>();
      eachLost(
        this.#ammo,
        (visit) => this.#bullet.eachPair(visit),
        contacts,
        (rank, normal) => {
          const pointer = this.#bullet.order!.bodyAt(rank);
          if (pointer !== undefined && !moved.has(pointer))
            moved.set(pointer, this.#nudge(pointer, normal));
        },
      );
      if (moved.size === 0) return;
      this.#bullet.findPairs();
      for (const putBack of moved.values()) putBack();
    }
  }

  #nudge(body: number, normal: readonly number[]): () => void {
    const { HEAPF32 } = this.#ammo;
    const at = (body + BODY.origin) >> 2;
    const before = HEAPF32.slice(at, at + 3);
    for (let k = 0; k < 3; k++) HEAPF32[at + k]! += NEARER * normal[k]!;
    return () => this.#ammo.HEAPF32.set(before, at);
  }
}
