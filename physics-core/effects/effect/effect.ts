import type { Chunk } from '../../base/chunk.js';
import type { Body } from '../../dynamics/body.js';
import type { Joint } from '../../dynamics/joint.js';
import type { SimulationNode } from '../../dynamics/node.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { EffectCost } from './cost.js';
import type { Effects } from './effects.js';

/** Who needs an effect: a node, or something outside the world that `world.effects` is to name. */
export interface Cause {
  readonly host: unknown;
}

/** Nodes by their numbers. */
export interface Numbered {
  body(id: number): Body | undefined;
  joint(id: number): Joint | undefined;
}

/** What of a body may change so that other effects act on it. */
export type BodyChange = 'mass' | 'load' | 'gravity' | 'damping' | 'rest';

/**
 * All that is to be known of an effect before there is one. Adding an effect is a file with a descriptor, and a line in
 * `all.ts`.
 */
export interface EffectDescriptor<E extends Effect = Effect> {
  /** As `world.effects` and the docs call it. */
  readonly name: string;
  /** What switches it on, for people. */
  readonly causes: string;
  /** Effects whose hooks come before its own in every stage of a step, by name, and why. */
  readonly after?: Readonly<Record<string, string>>;
  /** Effects that it comes and goes with. */
  readonly with?: readonly EffectDescriptor[];
  /** The bodies that cause it: looked at again when one of these changes. Undefined: this one does not. */
  readonly body?: {
    readonly on: readonly BodyChange[];
    reason(body: Body, effects: Effects): string | undefined;
  };
  /** The joints that cause it: looked at again whenever one changes. */
  readonly joint?: (joint: Joint) => string | undefined;
  /** Looked at in each step in which Bullet finds bodies near each other; given as `load` is. */
  found?: (simulation: Simulation, effects: Effects) => void;
  /** The chunk that its code comes in, which gives `load` where there is none before; undefined: it is always there. */
  readonly chunk?: Chunk<unknown>;
  /** Makes it for one world, when it is needed first. */
  load?: (simulation: Simulation, effects: Effects) => E;
}

/** Stages of a step in which effects act. */
export const STAGES = [
  'beforeStep',
  'found',
  'solve',
  'solved',
  'settle',
  'afterStep',
  'stepOver',
] as const;
export type Stage = (typeof STAGES)[number];

/** Something a plain scene of falling bodies can do without. It is called while at least one node causes it, and only then. */
export abstract class Effect {
  /** Why it is on: the nodes that need it, and what of them. */
  readonly #causes = new Map<Cause, string>();
  #ordered: readonly Cause[] | undefined;
  readonly cost = new EffectCost();
  /** Told when it comes on and when it goes off. */
  onswitch?: (on: boolean) => void;

  get active(): boolean {
    return this.#causes.size > 0;
  }

  /** The first cause, for people. */
  get because(): { node: Cause; reason: string } | undefined {
    const first = this.#causes.entries().next().value;
    return first && { node: first[0], reason: first[1] };
  }

  get causes(): IterableIterator<Cause> {
    return this.#causes.keys();
  }

  /** By the numbers of nodes, whoever came first: what they do adds up to the same bits. */
  protected get inOrder(): readonly Cause[] {
    const id = (cause: Cause): number => (cause as Partial<SimulationNode>).id ?? 0;
    return (this.#ordered ??= [...this.causes].sort((a, b) => id(a) - id(b)));
  }

  isNeededBy(node: Cause): boolean {
    return this.#causes.has(node);
  }

  need(node: Cause, reason: string): void {
    this.#causes.set(node, reason);
    this.#ordered = undefined;
    if (this.#causes.size === 1) this.onswitch?.(true);
  }

  /** The node causes it no more. */
  release(node: Cause): void {
    this.#ordered = undefined;
    if (this.#causes.delete(node) && this.#causes.size === 0) this.onswitch?.(false);
  }

  /** What stood for a node in Bullet is gone; the node may be made again. */
  unmade(node: Cause): void {
    this.release(node);
  }

  /** Nothing is known of the steps before: the world begins anew, goes back or ends. */
  reset?(reason: 'reset' | 'removed'): void;
  /** Water came, went, or is another: what rests may float otherwise. */
  waterChanged?(): void;
  /** What the next step asks of those before it, as plain data: nodes by their numbers. Undefined: nothing. */
  save?(): unknown;
  /** After a reset: goes on from what `save` gave. Bodies stand and move as they did. */
  load?(state: never, nodes: Numbered): void;

  /** Into how many parts, at least, a step of `dt` seconds must be split for it: asked before each. */
  parts?(dt: number): number;
  /** Before each step of Bullet, `dt` seconds. */
  beforeStep?(dt: number): void;
  /** When Bullet has found what touches, before its contacts are seen one by one. */
  found?(dt: number): void;
  /** When all contacts of the step are seen, before Bullet's solver. */
  solve?(dt: number): void;
  /** When Bullet's solver has given every body its velocity, before they move. */
  solved?(dt: number): void;
  /** Right after each step of Bullet, before anybody reads where it took the bodies. */
  settle?(dt: number): void;
  /** After each step of Bullet, when poses and velocities are read. */
  afterStep?(dt: number): void;
  /** After the last part of a step of `dt` seconds: once, however many there were. */
  stepOver?(dt: number): void;
  /** Sees every contact point between Bullet's contact search and its solver, by heap pointers. False: takes it back. */
  contact?(point: number, a: number, b: number): boolean;
  /** Whether it has to see those of the step that begins. */
  seesContacts?(): boolean;
}
