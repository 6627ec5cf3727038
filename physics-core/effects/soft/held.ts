import type { Body } from '../../dynamics/body.js';
import type { Component } from '../../solver/joints/forest.js';
import type { Rope } from './rope.js';
import type { RopeSource, Tie } from './settings.js';

/** What ties a point of a rope now: as it was when groups were made. */
export interface Held {
  readonly tie: Tie;
  readonly rope: Rope;
  readonly body: Body | undefined;
  readonly movable: boolean;
}

/** Who holds which points of which ropes: looked at before each step, and listed anew only where that is another. */
export class Holding {
  readonly #ropeOf: (source: RopeSource) => Rope | undefined;
  readonly #ties = new Set<Tie>();
  /** By their numbers: what they do adds up to the same bits, whoever came first. */
  #inOrder: readonly Tie[] = [];
  held: readonly Held[] = [];

  constructor(ropeOf: (source: RopeSource) => Rope | undefined) {
    this.#ropeOf = ropeOf;
  }

  get ties(): Iterable<Tie> {
    return this.#ties;
  }

  add(tie: Tie): void {
    this.#ties.add(tie);
    this.#sort();
  }

  delete(tie: Tie): void {
    this.#ties.delete(tie);
    this.#sort();
  }

  #sort(): void {
    this.#inOrder = [...this.#ties].sort((a, b) => a.id - b.id);
  }

  /** Whether any of them holds something else than when they were listed. */
  get changed(): boolean {
    let count = 0;
    for (const tie of this.#inOrder) {
      if (!this.#holds(tie)) continue;
      const known = this.held[count++];
      if (known?.tie !== tie || known.body !== tie.body) return true;
      if (known.movable !== (known.body?.movable ?? false)) return true;
    }
    return count !== this.held.length;
  }

  list(): void {
    this.held = this.#inOrder
      .filter((tie) => this.#holds(tie))
      .map((tie) => {
        const { rope, body } = tie;
        return { tie, rope: this.#ropeOf(rope!)!, body, movable: body?.movable ?? false };
      });
  }

  #holds({ rope: source, holds, index }: Tie): boolean {
    const rope = source && this.#ropeOf(source);
    return holds && rope !== undefined && rope.settings.enabled && index < rope.strand.points;
  }
}

/** Ropes that hang together by bodies that move, or by what joints hold those together with. */
export function together(
  ropes: readonly Rope[],
  held: readonly Held[],
  componentOf: (body: Body) => Component | undefined,
): Set<Set<Rope>> {
  const groupOf = new Map(ropes.map((rope) => [rope, new Set([rope])]));
  const byBody = new Map<object, Rope>();
  for (const { rope, body, movable } of held) {
    if (!body || !movable) continue;
    const whole = componentOf(body) ?? body;
    const other = byBody.get(whole) ?? rope;
    byBody.set(whole, other);
    const one = groupOf.get(rope)!;
    const two = groupOf.get(other)!;
    if (one === two) continue;
    for (const member of two) {
      one.add(member);
      groupOf.set(member, one);
    }
  }
  return new Set(groupOf.values());
}

/** The tied bodies of what hangs together. */
export interface Whole {
  readonly bodies: readonly Body[];
  /** Whether joints hold it. */
  readonly jointed: boolean;
}

/** The bodies that move, by what they hang together with, in the order in which they are tied. */
export function wholesOf(
  held: readonly Held[],
  componentOf: (body: Body) => Component | undefined,
): Whole[] {
  const wholes = new Map<object, Set<Body>>();
  for (const { body, movable } of held) {
    if (!body || !movable) continue;
    const whole = componentOf(body) ?? body;
    const bodies = wholes.get(whole) ?? new Set();
    wholes.set(whole, bodies.add(body));
  }
  return [...wholes.values()].map((own) => {
    const bodies = [...own];
    return { bodies, jointed: (componentOf(bodies[0]!)?.joints.length ?? 0) > 0 };
  });
}
