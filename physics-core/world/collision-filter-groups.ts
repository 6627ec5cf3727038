import type { BodyNode } from '../nodes/body.js';
import type { Pairs } from './pairs.js';
import type { World } from './world.js';

/** Bullet 2.82 keeps 16 signed bits per body. CollisionFilterGroups beyond the bits share the last one. */
const LAST_BIT = 14;
const EVERYTHING = -1;

/** Bodies that collide with the same others. */
interface FilterGroup {
  index: number;
  key: string;
  readonly bodies: Set<BodyNode>;
  mask: number;
  /** Those that its bits can't keep apart from it. */
  readonly blurred: Set<FilterGroup>;
  /** The body that is named as the pair filter's cause. */
  cause: BodyNode | undefined;
}

/** Whether all, some or none of the collidables of two kinds meet. */
type Meeting = 'all' | 'some' | 'none';

const bitOf = (index: number): number => 1 << Math.min(index, LAST_BIT);

/**
 * Bullet's collision groups, one bit per kind of body: those that are in the same collections have the same kind. Where
 * that can't tell (too many kinds, or collidables of one body in different collections) the pair filter decides at the
 * contact. A kind keeps its bit as long as it has bodies: an edit changes the groups of no body that it does not concern.
 */
export class CollisionFilterGroups {
  readonly #world: World;
  readonly #pairs: Pairs;
  readonly #byKey = new Map<string, FilterGroup>();
  readonly #byIndex: (FilterGroup | undefined)[] = [];
  readonly #of = new Map<BodyNode, FilterGroup>();

  constructor(world: World, pairs: Pairs) {
    this.#world = world;
    this.#pairs = pairs;
  }

  /** Bullet's collision group and mask of a body. */
  groupsOf(body: BodyNode): [group: number, mask: number] {
    const kind = this.#join(body);
    return [bitOf(kind.index), kind.mask];
  }

  /** Who is in which collection has changed. */
  refresh(): void {
    this.#world.registry.filter.forget();
    for (const body of this.#world.bodies)
      if (body.built && this.#of.get(body)?.key !== this.#keyOf(body)) this.leave(body);
    for (const body of this.#world.bodies) if (body.built) this.#join(body);
    // With itself, too: its bodies meet each other.
    for (const kind of this.#byIndex)
      if (kind) this.#compare(kind, this.#byIndex.slice(0, kind.index + 1));
  }

  /** The body goes, or will be of another kind. */
  leave(body: BodyNode): void {
    const kind = this.#of.get(body);
    if (!kind) return;
    this.#of.delete(body);
    kind.bodies.delete(body);
    if (kind.bodies.size === 0) this.#end(kind);
    this.#updateCause(kind);
  }

  #join(body: BodyNode): FilterGroup {
    const key = this.#keyOf(body);
    const known = this.#of.get(body);
    if (known?.key === key) return known;
    this.leave(body);
    this.#world.registry.filter.forget();
    const same = this.#byKey.get(key);
    const kind = same ?? this.#begin(key);
    this.#of.set(body, kind);
    kind.bodies.add(body);
    if (!same) this.#compare(kind, this.#byIndex);
    return kind;
  }

  #begin(key: string): FilterGroup {
    const free = this.#byIndex.indexOf(undefined);
    const index = free < 0 ? this.#byIndex.length : free;
    const kind: FilterGroup = {
      index,
      key,
      bodies: new Set(),
      mask: EVERYTHING,
      blurred: new Set(),
      cause: undefined,
    };
    this.#byIndex[index] = kind;
    this.#byKey.set(key, kind);
    return kind;
  }

  #end(kind: FilterGroup): void {
    this.#byKey.delete(kind.key);
    this.#byIndex[kind.index] = undefined;
    while (this.#byIndex.length > 0 && !this.#byIndex.at(-1)) this.#byIndex.pop();
    for (const other of kind.blurred) {
      other.blurred.delete(kind);
      this.#updateCause(other);
    }
    kind.blurred.clear();
  }

  #keyOf(body: BodyNode): string {
    const { settings, moves } = body;
    const rules = body.isObstacle
      ? 'obstacle'
      : [idOf(settings.asked('collider')), settings.asked('collisionRules')].join();
    const lists = body.parts.map(({ collidable }) =>
      this.#pairs.listing(collidable).map(idOf).join(),
    );
    return [rules, moves, ...new Set(lists.sort())].join(' ');
  }

  /** Of two kinds the one with the higher bit leaves the other out; either side of a pair may refuse it. */
  #compare(kind: FilterGroup, others: readonly (FilterGroup | undefined)[]): void {
    for (const other of others) {
      if (!other) continue;
      const [low, high] = kind.index < other.index ? [kind, other] : [other, kind];
      const meeting = this.#meeting(kind, other);
      const shared = high.index >= LAST_BIT;
      const apart = meeting === 'none' && !shared;
      const { mask } = high;
      high.mask = apart ? mask & ~bitOf(low.index) : mask | bitOf(low.index);
      if (high === other && high.mask !== mask) this.#regroup(high);
      const blurred = meeting === 'some' || (meeting === 'none' && shared);
      this.#blur(kind, other, blurred);
      this.#blur(other, kind, blurred);
    }
  }

  /** Another kind has taken a lower bit than theirs. */
  #regroup({ bodies }: FilterGroup): void {
    for (const body of [...bodies]) body.updateMembership();
  }

  #blur(kind: FilterGroup, other: FilterGroup, blurred: boolean): void {
    if (blurred) kind.blurred.add(other);
    else kind.blurred.delete(other);
    this.#updateCause(kind);
  }

  #updateCause(kind: FilterGroup): void {
    const { filter } = this.#world.registry;
    const { cause, blurred, bodies } = kind;
    const [first] = bodies;
    const wanted = blurred.size === 0 ? undefined : cause && bodies.has(cause) ? cause : first;
    if (wanted === cause) return;
    if (cause) filter.drop(cause);
    if (wanted) filter.need(wanted, 'collidables');
    kind.cause = wanted;
  }

  #meeting(a: FilterGroup, b: FilterGroup): Meeting {
    const [sideA] = a.bodies;
    const [sideB] = b.bodies;
    const [partsA, partsB] = [sideA!.parts, sideB!.parts];
    if (partsA.length === 0 || partsB.length === 0) return 'all';
    let met = 0;
    for (const { collidable: first } of partsA)
      for (const { collidable: second } of partsB)
        if (this.#pairs.meet(sideA!, first, sideB!, second)) met++;
    if (met === 0) return 'none';
    return met === partsA.length * partsB.length ? 'all' : 'some';
  }
}

const idOf = (node: { id: number } | null | undefined): number => node?.id ?? 0;
