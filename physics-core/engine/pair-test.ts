import type { Ammo } from './ammo.js';
import type { Engine } from './engine.js';
import type { BtBody } from './heap.js';
import { MANIFOLD_POINT as POINT } from './offsets.js';

/** Points of one step. What is beyond them is left to the next step. */
const ROOM = 64;

type DynamicsWorld = Ammo['btDiscreteDynamicsWorld']['prototype'];

/** A contact point that is none of Bullet's world, with heap pointers of all three. */
interface FoundPoint {
  pointer: number;
  a: number;
  b: number;
}

/** Asks Bullet where two bodies touch now, between its steps. The points are kept until they are cleared. */
export class PairTest {
  readonly #ammo: Ammo;
  readonly #callback: Ammo['ConcreteContactResultCallback']['prototype'];
  /** The build has no way to give memory back: this is taken once. */
  readonly #memory: number;
  readonly #points: FoundPoint[];
  #count = 0;
  /** The world that it was asked for last. */
  #world: DynamicsWorld | undefined;

  constructor(ammo: Ammo) {
    this.#ammo = ammo;
    this.#memory = ammo._malloc(ROOM * POINT.size);
    this.#points = Array.from({ length: ROOM }, (_, i) => ({
      pointer: this.#memory + i * POINT.size,
      a: 0,
      b: 0,
    }));
    this.#callback = new ammo.ConcreteContactResultCallback();
    this.#callback.addSingleResult = (point, first, _part1, _index1, second) => {
      this.#note(point, first, second);
      return 0;
    };
  }

  clear(world: DynamicsWorld): void {
    this.#world = world;
    this.#count = 0;
  }

  /** Points so far. */
  get count(): number {
    return this.#count;
  }

  touch(a: BtBody, b: BtBody): void {
    this.#world!.contactPairTest(a, b, this.#callback as never);
  }

  #note(point: number, first: number, second: number): void {
    const ammo = this.#ammo;
    const object = (wrapper: number): number =>
      ammo.getPointer(
        ammo.wrapPointer(wrapper, ammo.btCollisionObjectWrapper).getCollisionObject(),
      );
    const pointer = this.add(object(first), object(second));
    if (pointer !== 0) ammo.HEAPU8.copyWithin(pointer, point, point + POINT.size);
  }

  /** Room for one more point; 0: there is none. */
  add(a: number, b: number): number {
    if (this.#count === ROOM) return 0;
    const found = this.#points[this.#count++]!;
    found.a = a;
    found.b = b;
    return found.pointer;
  }

  /** Of those that a world asked for. */
  each(
    world: DynamicsWorld,
    visit: (pointer: number, a: number, b: number) => void,
    from = 0,
  ): void {
    if (world !== this.#world) return;
    for (let i = from; i < this.#count; i++) {
      const { pointer, a, b } = this.#points[i]!;
      visit(pointer, a, b);
    }
  }
}

/** The one of an engine. */
export const pairTestOf = (engine: Engine): PairTest =>
  (engine.pairTest ??= new PairTest(engine.ammo));
