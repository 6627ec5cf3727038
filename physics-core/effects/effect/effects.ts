import type { Body } from '../../dynamics/body.js';
import type { Joint } from '../../dynamics/joint.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { eachPoint } from '../../engine/manifold.js';
import { MEASURED_EVERY } from './cost.js';
import {
  STAGES,
  type BodyChange,
  type Cause,
  type Effect,
  type EffectDescriptor,
  type Numbered,
  type Stage,
} from './effect.js';
import { reportOf, type EffectReport } from './report.js';

/**
 * The effects of one world. Each is made when it is first needed; the lists of what is called in a step hold those that
 * are on, and are made anew when one comes or goes: what is off is not called at all.
 */
export class Effects {
  readonly #simulation: Simulation;
  readonly #ordered: readonly EffectDescriptor[];
  /** Those that bodies or joints cause. */
  readonly #byBodies: readonly EffectDescriptor[];
  readonly #byJoints: readonly EffectDescriptor[];
  readonly #made = new Map<EffectDescriptor, Effect>();
  /** Those of them that a node causes. */
  readonly #caused = new Map<EffectDescriptor, Effect>();
  #stale = false;
  #on: readonly Effect[] = [];
  readonly #stages: Record<Stage, readonly Effect[]>;
  #contacts: readonly Effect[] = [];
  #splitting: readonly Effect[] = [];
  /** Those that a step's contacts go to. */
  readonly #seeing: Effect[] = [];
  #steps = 0;
  /** Whether what the present step costs is measured. */
  #measured = false;

  /** `ordered`: as `inOrder` has them. */
  constructor(simulation: Simulation, ordered: readonly EffectDescriptor[]) {
    this.#simulation = simulation;
    this.#ordered = ordered;
    this.#stages = Object.fromEntries(STAGES.map((stage) => [stage, []])) as never;
    this.#byBodies = ordered.filter((each) => each.body);
    this.#byJoints = ordered.filter((each) => each.joint);
  }

  /** The effect of this world, made if it was not needed before. */
  get<E extends Effect>(descriptor: EffectDescriptor<E>): E {
    return this.find(descriptor) ?? this.#make(descriptor);
  }

  /** Undefined: nobody has needed it yet. */
  find<E extends Effect>(descriptor: EffectDescriptor<E>): E | undefined {
    return this.#made.get(descriptor) as E | undefined;
  }

  /** Undefined: no node causes it now. */
  caused<E extends Effect>(descriptor: EffectDescriptor<E>): E | undefined {
    return this.#caused.get(descriptor) as E | undefined;
  }

  /** Whether it is on. */
  active(descriptor: EffectDescriptor): boolean {
    if (descriptor.with) return descriptor.with.some((each) => this.active(each));
    return this.#caused.has(descriptor);
  }

  #make<E extends Effect>(descriptor: EffectDescriptor<E>): E {
    if (!descriptor.load) throw new Error(`${descriptor.name} is needed before its code is here`);
    const effect = descriptor.load(this.#simulation, this);
    effect.onswitch = (on) => this.#switch(descriptor, effect, on);
    this.#made.set(descriptor, effect);
    return effect;
  }

  // ---- causes -----------------------------------------------------------------------------------------------------

  /** A body is made as its fields say: it needs its effects. */
  bodyMade(body: Body): void {
    for (const descriptor of this.#byBodies)
      this.#review(descriptor, body, descriptor.body!.reason(body, this));
  }

  /** Effects that such a change of a body concerns are needed by it now, or no more. */
  bodyChanged(body: Body, change: BodyChange): void {
    for (const descriptor of this.#byBodies)
      if (descriptor.body!.on.includes(change))
        this.#review(descriptor, body, descriptor.body!.reason(body, this));
  }

  /** Code has come since it was made: what it causes by that it has not caused before. */
  codeCame(body: Body): void {
    for (const descriptor of this.#byBodies)
      if (descriptor.chunk && !this.find(descriptor)?.isNeededBy(body))
        this.#review(descriptor, body, descriptor.body!.reason(body, this));
  }

  /** A joint came, went, or is another now. */
  jointChanged(joint: Joint): void {
    for (const descriptor of this.#byJoints)
      this.#review(descriptor, joint, descriptor.joint!(joint));
  }

  /** Bullet's contact search is over. */
  found(): void {
    if (this.#simulation.bullet.manifoldCount === 0) return;
    for (const descriptor of this.#ordered) descriptor.found?.(this.#simulation, this);
  }

  #review(descriptor: EffectDescriptor, node: Cause, reason: string | undefined): void {
    if (reason === undefined) this.find(descriptor)?.release(node);
    // What it does is of no account until something else has its code come; then all bodies are looked at again.
    else if (descriptor.load) this.get(descriptor).need(node, reason);
  }

  /** What stood for a node in Bullet is gone. */
  unmade(node: Cause): void {
    for (const effect of this.#made.values()) effect.unmade(node);
  }

  waterChanged(): void {
    for (const effect of this.#made.values()) effect.waterChanged?.();
  }

  // ---- going back -----------------------------------------------------------------------------------------------------

  reset(reason: 'reset' | 'removed'): void {
    for (const descriptor of this.#ordered) this.find(descriptor)?.reset?.(reason);
  }

  /** What each keeps from step to step, by its name. */
  save(): Record<string, unknown> {
    const saved: Record<string, unknown> = {};
    for (const descriptor of this.#ordered) {
      const state = this.find(descriptor)?.save?.();
      if (state !== undefined) saved[descriptor.name] = state;
    }
    return saved;
  }

  load(saved: Readonly<Record<string, unknown>>, nodes: Numbered): void {
    for (const descriptor of this.#ordered) {
      const state = saved[descriptor.name];
      if (state !== undefined && descriptor.load)
        this.get(descriptor).load?.(state as never, nodes);
    }
  }

  // ---- a step -----------------------------------------------------------------------------------------------------

  #switch(descriptor: EffectDescriptor, effect: Effect, on: boolean): void {
    this.#stale = true;
    if (on) this.#caused.set(descriptor, effect);
    else this.#caused.delete(descriptor);
  }

  /** The lists of what is on. Those that are being walked stay as they are. */
  #refresh(): void {
    if (!this.#stale) return;
    this.#stale = false;
    this.#on = this.#ordered.flatMap((each) => (this.active(each) ? [this.get(each)] : []));
    for (const stage of STAGES) this.#stages[stage] = this.#on.filter((effect) => effect[stage]);
    this.#contacts = this.#on.filter((effect) => effect.contact);
    this.#splitting = this.#on.filter((effect) => effect.parts);
  }

  /** Into how many parts the step that begins must be split, `dt` seconds. */
  parts(dt: number): number {
    this.#refresh();
    let parts = 1;
    for (const effect of this.#splitting) parts = Math.max(parts, effect.parts!(dt));
    return parts;
  }

  /** Calls those that are on, in order. */
  run(stage: Stage, dt: number): void {
    this.#refresh();
    for (const effect of this.#stages[stage]) {
      const start = this.#measured ? performance.now() : 0;
      effect[stage]!(dt);
      if (this.#measured) effect.cost.add(start);
    }
  }

  /** The step is over: what each has cost, where that was measured, and whom it concerns. */
  stepOver(dt: number): void {
    this.run('stepOver', dt);
    if (this.#measured) for (const effect of this.#made.values()) note(effect);
    this.#measured = ++this.#steps % MEASURED_EVERY === 0;
  }

  /** Shows every contact point of the step to those that see contacts; between Bullet's search and its solver. */
  seeContacts(): void {
    const seeing = this.#seeing;
    seeing.length = 0;
    for (const effect of this.#contacts) if (effect.seesContacts?.() ?? true) seeing.push(effect);
    if (seeing.length > 0) this.#simulation.bullet.eachAwakeTouching(this.#see);
  }

  readonly #see = (manifold: number, a: number, b: number): void => {
    eachPoint(this.#simulation.engine.ammo, manifold, (point) => this.#seePoint(point, a, b));
  };

  #seePoint(point: number, a: number, b: number): void {
    for (const effect of this.#seeing) {
      const start = this.#measured ? performance.now() : 0;
      const stands = effect.contact!(point, a, b);
      if (this.#measured) effect.cost.add(start);
      if (!stands) return;
    }
  }

  // ---- looking in -------------------------------------------------------------------------------------------------

  report(): EffectReport[] {
    return this.#ordered.map((descriptor) => reportOf(descriptor, this));
  }
}

/** What went off within the step was called in it, too. */
function note(effect: Effect): void {
  if (effect.cost.called > 0 || (effect.active && isCalled(effect))) effect.cost.note();
}

/** By steps; others note themselves what a frame of theirs costs. */
const isCalled = (effect: Effect): boolean =>
  effect.contact !== undefined || STAGES.some((stage) => effect[stage]);
