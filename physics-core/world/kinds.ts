import type { BodyNode } from '../nodes/body.js';
import type { CollidableNode } from '../nodes/collidable.js';
import type { Pairs, Side } from './pairs.js';
import type { World } from './world.js';

/** Bullet 2.82 keeps 16 signed bits per body. Kinds beyond the bits share the last one. */
const LAST_BIT = 14;
const EVERYTHING = -1;

/** Bodies that collide with the same others. */
interface Kind {
  index: number;
  key: string;
  side: Side;
  parts: CollidableNode[];
  mask: number;
}

/** Whether all, some or none of the collidables of two kinds meet. */
type Meeting = 'all' | 'some' | 'none';

const bitOf = (index: number): number => 1 << Math.min(index, LAST_BIT);

/**
 * Bullet's collision groups, one bit per kind of body: those that are in the same collections have the same kind. Where
 * that can't tell (too many kinds, or collidables of one body in different collections) the pair filter decides at the
 * contact.
 */
export class Kinds {
  readonly #world: World;
  readonly #pairs: Pairs;
  readonly #kinds: Kind[] = [];
  readonly #byKey = new Map<string, Kind>();

  constructor(world: World, pairs: Pairs) {
    this.#world = world;
    this.#pairs = pairs;
  }

  clear(): void {
    this.#kinds.length = 0;
    this.#byKey.clear();
    this.#world.registry.filter.clear();
  }

  groupsOf(body: BodyNode): [group: number, mask: number] {
    const kind = this.#kindOf(body);
    return [bitOf(kind.index), kind.mask];
  }

  #kindOf(body: BodyNode): Kind {
    const parts = body.parts.map(({ collidable }) => collidable);
    const key = this.#keyOf(body, parts);
    return this.#byKey.get(key) ?? this.#add(body, parts, key);
  }

  #keyOf(body: BodyNode, parts: CollidableNode[]): string {
    const { settings, movable } = body;
    const rules = body.isObstacle
      ? 'obstacle'
      : [idOf(settings.asked('collider')), settings.asked('collisionRules')].join();
    const lists = parts.map((part) => this.#pairs.listing(part).map(idOf).join());
    return [rules, movable, ...new Set(lists.sort())].join(' ');
  }

  /** Each kind leaves out those before it; either side of a pair may refuse it. */
  #add(body: BodyNode, parts: CollidableNode[], key: string): Kind {
    const { movable, isObstacle, settings } = body;
    const side = { movable, isObstacle, settings };
    const kind: Kind = { index: this.#kinds.length, key, side, parts, mask: EVERYTHING };
    this.#byKey.set(key, kind);
    this.#kinds.push(kind);
    let exact = true;
    for (const other of this.#kinds) {
      const meeting = this.#meeting(kind, other);
      const shared = Math.max(kind.index, other.index) >= LAST_BIT;
      if (meeting === 'none' && !shared) kind.mask &= ~bitOf(other.index);
      if (meeting === 'some' || (meeting === 'none' && shared)) exact = false;
    }
    if (!exact) this.#world.registry.filter.need(body, 'collidables');
    return kind;
  }

  #meeting(a: Kind, b: Kind): Meeting {
    if (a.parts.length === 0 || b.parts.length === 0) return 'all';
    let met = 0;
    for (const first of a.parts)
      for (const second of b.parts) if (this.#pairs.meet(a.side, first, b.side, second)) met++;
    if (met === 0) return 'none';
    return met === a.parts.length * b.parts.length ? 'all' : 'some';
  }
}

const idOf = (node: { id: number } | null | undefined): number => node?.id ?? 0;
