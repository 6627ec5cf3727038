import {
  codecs,
  defaultOf,
  SI,
  type PhysicsNode,
  type ProblemReport,
} from '../../../physics-core/inside.js';
import type { Names, Watcher } from '../scopes/names.js';
import type { Scope } from '../scopes/scope.js';
import { known } from '../words/attributes.js';
import { attribute, typeOf, type Field } from '../words/dom.js';
import {
  fieldsByAttribute,
  forCore,
  holdsNodes,
  inFileUnits,
  inSI,
  isKept,
} from '../words/fields.js';
import { Authored } from './authored.js';
import { Findings } from './findings.js';
import { inCore, inPage } from './in-page.js';
import { Namers, nodesGiven } from './named.js';
import type { StandIn } from './stand-in.js';
import type { PageWorld, Surroundings } from './surroundings.js';

/**
 * What ties one physics element, of either spelling, to its node in the core. An element that only stands for
 * another by USE has none: `bindingOf` gives that of its DEF.
 */
export class Binding extends Findings implements Watcher {
  #scope: Scope | null = null;
  #scene: Surroundings | null = null;
  #world: PageWorld | null = null;
  /** What it was taken out of, with whatever stood around it: there its last events are heard. */
  leftFrom: Element | undefined;
  /** Null while something it needs is missing. */
  node: PhysicsNode | null = null;
  /** What it moves and takes its Shapes from, by a shortcut or in X3DOM's older dialect. */
  standIn: StandIn | undefined;
  readonly watching = new Set<Names>();
  /** Those that hold its node, and are told when it is made again. */
  readonly users = new Set<Binding>();
  readonly uses = new Set<Binding>();
  /** Relations as last handed to the core. */
  relations: Record<string, unknown> = {};
  /** Its node was made, changed its place, or went: for what draws it by itself. */
  onnode?: () => void;
  readonly #authored = new Authored(this.element, this.type);

  // ---- where it stands ------------------------------------------------------------------------------------------

  /** Null while the element is in no `<x3d>`, as is `scene`. */
  get scope(): Scope | null {
    return this.#scope;
  }

  get scene(): Surroundings | null {
    return this.#scene;
  }

  enter(scope: Scope, scene: Surroundings): void {
    this.#scope = scope;
    this.#scene = scene;
    namers.note(this, [], this.#authored.allNamed);
  }

  leave(): void {
    namers.note(this, this.#authored.allNamed, []);
    this.#scope = null;
    this.#scene = null;
    this.world = null;
  }

  /** The world that it lives in, whether its node could be made yet or not. */
  get world(): PageWorld | null {
    return this.#world;
  }

  set world(world: PageWorld | null) {
    if (world === this.#world) return;
    this.#world?.leave(this);
    this.#world = world;
    world?.enter(this);
  }

  is(...names: string[]): boolean {
    return names.includes(this.type.name);
  }

  get isCollidable(): boolean {
    return this.is('CollidableShape', 'CollidableOffset');
  }

  get units() {
    return this.#scope?.units ?? SI;
  }

  dirty(): void {
    this.#scene?.dirty(this);
  }

  protected tell(report: ProblemReport): void {
    this.#scene?.reports.report(report, this);
  }

  settle(code: string, attributeName?: string): void {
    this.#scene?.reports.settle(this, attributeName, code);
  }

  // ---- what the author wrote --------------------------------------------------------------------------------------

  /** What the author wrote for a field: by script since, else in the attribute; undefined when nothing. */
  authored(name: string): unknown {
    return this.#authored.get(name);
  }

  /** All that the author wrote, in SI. */
  authoredFields(): Record<string, unknown> {
    return this.#authored.fields(this.units);
  }

  /** Elements named for a field that holds nodes; undefined: its children stand for it. */
  named(name: string): Element[] | undefined {
    return this.#authored.named(name);
  }

  /** Whether the author wrote any of these fields. */
  wrote(...names: string[]): boolean {
    return names.some((name) => this.authored(name) !== undefined);
  }

  /** What the author wrote for a field holds again, or its default. */
  restore(name: string): void {
    const field = this.type.fields[name];
    const ours = holdsNodes(field) && field.access !== 'outputOnly';
    const value = ours ? undefined : this.authored(name);
    if (value === undefined) this.node?.unset(name);
    else this.node?.set(name, forCore(field, value, this.units), value);
  }

  // ---- attributes -------------------------------------------------------------------------------------------------

  /** An attribute was written or removed. */
  attributeChanged(attributeName: string): void {
    const name = fieldsByAttribute(this.type).get(attributeName.toLowerCase());
    if (name === undefined) return this.#otherAttribute(attributeName);
    const field = this.type.fields[name];
    if (field.access === 'outputOnly') return this.restore(name);
    if (holdsNodes(field)) return this.#setNodes(name, null);
    this.#authored.takeBack(name);
    this.#tookBack(name);
  }

  /** It was written with what it says already: no edit, but perhaps meant as one. */
  attributeRepeated(attributeName: string): void {
    const name = fieldsByAttribute(this.type).get(attributeName.toLowerCase());
    const live = name !== undefined && this.type.fields[name].instead;
    if (live && !this.#authored.byScript(name)) this.restore(name);
  }

  /** Script's word is gone: that of the markup holds, or the default. */
  #tookBack(name: string): void {
    if (this.#isPlanned(name)) this.dirty();
    else this.restore(name);
    this.#valueChanged();
  }

  #otherAttribute(attributeName: string): void {
    if (known(this.type, attributeName)) this.dirty();
    else if (attribute(this.element, attributeName) === null)
      this.settle('unknown-attribute', attributeName);
    else this.fault((faults) => faults.unknownAttribute(this, attributeName));
  }

  // ---- properties -------------------------------------------------------------------------------------------------

  /**
   * A property was set: the value is in file units; a joint's body may be an element or its name. Nothing, as frameworks
   * set what they no longer bind: script takes its word back.
   */
  set(name: string, value: unknown): void {
    const field = this.type.fields[name];
    if (field.access === 'outputOnly') return void this.node?.set(name, value);
    if (holdsNodes(field) && field.access !== 'inputOnly') return this.#setNodes(name, value);
    if (value === undefined || value === null) {
      if (this.#authored.takeBack(name)) this.#tookBack(name);
      return;
    }
    if (field.access === 'inputOnly') return this.event(name, value);
    const accepted = codecs[field.type].accept(value);
    if (accepted !== undefined || !this.node) this.#authored.set(name, accepted ?? value);
    if (this.#isPlanned(name)) this.dirty();
    else this.node?.set(name, forCore(field, value, this.units), value);
    this.#valueChanged();
  }

  /** An X3D event: a ROUTE, setFieldValue. */
  event(name: string, value: unknown): void {
    const field = this.type.fields[name];
    if (field.access === 'inputOnly')
      return this.node?.event(name, inCore(value, this.units, ownBinding));
    if (holdsNodes(field)) return this.#setNodes(name, value);
    const accepted = codecs[field.type].accept(value);
    if (this.node && !this.#isPlanned(name)) this.node.event(name, inSI(field, value, this.units));
    else if (accepted !== undefined || !this.node) this.#authored.set(name, accepted ?? value);
    if (this.#isPlanned(name)) this.dirty();
    this.#valueChanged();
  }

  /** Whether the node's value is not the field's own but what the plan makes of it: a place in another frame. */
  #isPlanned(name: string): boolean {
    return this.node !== null && name in this.relations;
  }

  #valueChanged(): void {
    if (this.isCollidable) this.#scene?.placeChanged(this);
  }

  #setNodes(name: string, value: unknown): void {
    const before = this.named(name) ?? [];
    const given = nodesGiven(value);
    if (given === undefined) this.#authored.takeBack(name);
    else this.#authored.set(name, given);
    const after = this.named(name) ?? [];
    if (this.#scope) namers.note(this, before, after);
    this.dirty();
    for (const element of [...before, ...after]) ownBinding(element)?.dirty();
  }

  /** The live value, or before there is a node what was asked for; a fresh copy in file units. */
  get(name: string): unknown {
    const field = this.type.fields[name];
    const body = PLACE[name] && this.#movedBy();
    if (body) return body.get(PLACE[name]);
    if (holdsNodes(field)) return this.#getNodes(name, field);
    if (this.node && !(name in this.relations))
      return inFileUnits(field, this.node.get(name), this.units);
    const codec = codecs[field.type];
    const asked = this.authored(name);
    const accepted = asked === undefined ? undefined : codec.accept(asked);
    return codec.copy(accepted ?? defaultOf(field, this.#scope?.version ?? 4));
  }

  #getNodes(name: string, field: Field): unknown {
    const elements = this.named(name);
    const kept = field.type === 'SFNode' ? elements?.[0] : elements;
    const nodes = this.node && !isKept(field) ? this.node.get(name) : kept;
    return inPage(nodes ?? field.default, this.units);
  }

  /** A collidable of a body is where that is. */
  #movedBy(): Binding | undefined {
    const body = this.is('CollidableShape')
      ? this.#scene?.drawing.bodyMoving(this.element)
      : undefined;
    return body?.node ? body : undefined;
  }

  // ---- ties to others -----------------------------------------------------------------------------------------

  /** Notes that this node holds that of `other`. */
  use(other: Binding): Binding {
    this.uses.add(other);
    other.users.add(this);
    return other;
  }

  /** Forgets what it knew of its surroundings, before `plan` reads them anew. */
  override beginPlan(): void {
    for (const other of this.uses) other.users.delete(this);
    this.uses.clear();
    for (const names of this.watching) names.unwatch(this);
    this.watching.clear();
    this.#scene?.readers.forget(this);
    super.beginPlan();
  }
}

/** Fields of a collidable that its body decides, by the body's own. */
const PLACE: Record<string, string> = { translation: 'position', rotation: 'orientation' };

/** Which nodes that stand in a scene name which elements for their fields. */
export const namers = new Namers<Binding>();

const bindings = new WeakMap<Element, Binding>();

/** The binding of a physics element itself; undefined for other elements and those that stand for another. */
export function ownBinding(element: Element): Binding | undefined {
  const known = bindings.get(element);
  if (known) return known;
  const type = typeOf(element);
  if (!type) return undefined;
  const binding = new Binding(element, type);
  bindings.set(element, binding);
  return binding;
}
