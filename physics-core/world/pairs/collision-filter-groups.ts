import { pairFilter } from '../../effects/contacts/effects.js';
import type { CollidableNode } from '../../nodes/collision/collidable.js';
import type { BodyNode } from '../../nodes/body/body.js';
import type { NodeWorld } from '../../nodes/node/node-world.js';

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

/** Who is in which collection, and who may meet whom. */
interface Membership {
  listing(collidable: CollidableNode): readonly { id: number }[];
  meet(a: BodyNode, first: CollidableNode, b: BodyNode, second: CollidableNode): boolean;
}

/** Whether all, some or none of the collidables of two groups meet. */
type Meeting = 'all' | 'some' | 'none';

const bitOf = (index: number): number => 1 << Math.min(index, LAST_BIT);

/**
 * Bullet's collision groups, one bit per group of body: those that are in the same collections have the same group. Where
 * that can't tell (too many groups, or collidables of one body in different collections) the pair filter decides at the
 * contact. A group keeps its bit as long as it has bodies: an edit changes the groups of no body that it does not concern.
 */
export class CollisionFilterGroups {
  readonly #world: NodeWorld;
  readonly #pairs: Membership;
  readonly #bodies: Iterable<BodyNode>;
  readonly #byKey = new Map<string, FilterGroup>();
  readonly #byIndex: (FilterGroup | undefined)[] = [];
  readonly #of = new Map<BodyNode, FilterGroup>();

  constructor(world: NodeWorld, pairs: Membership, bodies: Iterable<BodyNode>) {
    this.#world = world;
    this.#pairs = pairs;
    this.#bodies = bodies;
  }

  /** Bullet's collision group and mask of a body. */
  groupsOf(body: BodyNode): [group: number, mask: number] {
    const group = this.#join(body);
    return [bitOf(group.index), group.mask];
  }

  /** Who is in which collection has changed. */
  refresh(): void {
    this.#world.registry.find(pairFilter)?.forget();
    for (const body of this.#bodies)
      if (body.built && this.#of.get(body)?.key !== this.#keyOf(body)) this.leave(body);
    for (const body of this.#bodies) if (body.built) this.#join(body);
    // With itself, too: its bodies meet each other.
    for (const group of this.#byIndex)
      if (group) this.#compare(group, this.#byIndex.slice(0, group.index + 1));
  }

  /** The body goes, or will be of another group. */
  leave(body: BodyNode): void {
    const group = this.#of.get(body);
    if (!group) return;
    this.#of.delete(body);
    group.bodies.delete(body);
    if (group.bodies.size === 0) this.#end(group);
    this.#updateCause(group);
  }

  #join(body: BodyNode): FilterGroup {
    const key = this.#keyOf(body);
    const known = this.#of.get(body);
    if (known?.key === key) return known;
    this.leave(body);
    this.#world.registry.find(pairFilter)?.forget();
    const same = this.#byKey.get(key);
    const group = same ?? this.#begin(key);
    this.#of.set(body, group);
    group.bodies.add(body);
    if (!same) this.#compare(group, this.#byIndex);
    return group;
  }

  #begin(key: string): FilterGroup {
    const free = this.#byIndex.indexOf(undefined);
    const index = free < 0 ? this.#byIndex.length : free;
    const group: FilterGroup = {
      index,
      key,
      bodies: new Set(),
      mask: EVERYTHING,
      blurred: new Set(),
      cause: undefined,
    };
    this.#byIndex[index] = group;
    this.#byKey.set(key, group);
    return group;
  }

  #end(group: FilterGroup): void {
    this.#byKey.delete(group.key);
    this.#byIndex[group.index] = undefined;
    while (this.#byIndex.length > 0 && !this.#byIndex.at(-1)) this.#byIndex.pop();
    for (const other of group.blurred) {
      other.blurred.delete(group);
      this.#updateCause(other);
    }
    group.blurred.clear();
  }

  #keyOf(body: BodyNode): string {
    const { settings, isDynamic } = body;
    const rules = body.isObstacle
      ? 'obstacle'
      : [idOf(settings.asked('collider')), settings.asked('collisionRules')].join();
    const lists = body.parts.map(({ collidable }) =>
      this.#pairs.listing(collidable).map(idOf).join(),
    );
    return [rules, isDynamic, ...new Set(lists.sort())].join(' ');
  }

  /** Of two groups the one with the higher bit leaves the other out; either side of a pair may refuse it. */
  #compare(group: FilterGroup, others: readonly (FilterGroup | undefined)[]): void {
    for (const other of others) {
      if (!other) continue;
      const [low, high] = group.index < other.index ? [group, other] : [other, group];
      const meeting = this.#meeting(group, other);
      const shared = high.index >= LAST_BIT;
      const apart = meeting === 'none' && !shared;
      const { mask } = high;
      high.mask = apart ? mask & ~bitOf(low.index) : mask | bitOf(low.index);
      if (high === other && high.mask !== mask) this.#regroup(high);
      const blurred = meeting === 'some' || (meeting === 'none' && shared);
      this.#blur(group, other, blurred);
      this.#blur(other, group, blurred);
    }
  }

  /** Another group has taken a lower bit than theirs. */
  #regroup({ bodies }: FilterGroup): void {
    for (const body of [...bodies]) body.presence.update();
  }

  #blur(group: FilterGroup, other: FilterGroup, blurred: boolean): void {
    if (blurred) group.blurred.add(other);
    else group.blurred.delete(other);
    this.#updateCause(group);
  }

  #updateCause(group: FilterGroup): void {
    const { registry: effects } = this.#world;
    const { cause, blurred, bodies } = group;
    const [first] = bodies;
    const wanted = blurred.size === 0 ? undefined : cause && bodies.has(cause) ? cause : first;
    if (wanted === cause) return;
    if (cause) effects.find(pairFilter)?.release(cause);
    if (wanted) effects.get(pairFilter).need(wanted, 'collidables');
    group.cause = wanted;
  }

  #meeting(a: FilterGroup, b: FilterGroup): Meeting {
    const [sideA] = a.bodies;
    const [sideB] = b.bodies;
    const partsA = sideA!.parts;
    const partsB = sideB!.parts;
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
