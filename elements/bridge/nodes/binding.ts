import { codecs, defaultOf, SI, type PhysicsNode } from '../../../physics-core/inside.js';
import { attribute, typeOf, type Field } from '../document/dom.js';
import { Findings } from './findings.js';
import { authoredText, fieldsByAttribute, holdsNodes, inFileUnits, inSI } from './fields.js';
import { inCore, inPage } from './in-page.js';
import { elementsAmong, nodesGiven, noteNamed } from './named.js';
import type { Names } from '../document/names.js';
import type { GeometryData } from '../geometry/reader.js';
import { known, unknownAttribute } from '../document/markup.js';
import type { StandIn } from '../document/shortcuts.js';
import type { PageWorld } from './worlds.js';

/** The Transform that a body stands for, and what `for` says. */
export interface Place {
  transform: Element | undefined;
  name: string | null;
}

/**
 * What ties one physics element, of either spelling, to its node in the core. An element that only stands for
 * another by USE has none: `bindingOf` gives that of its DEF.
 */
export class Binding extends Findings {
  protected override get self(): Binding {
    return this;
  }

  #world: PageWorld | null = null;
  /** Null while something it needs is missing. */
  node: PhysicsNode | null = null;
  /** What it moves and takes its Shapes from, by a shortcut or in X3DOM's older dialect. */
  standIn: StandIn | undefined;
  /** What its node was last placed by. */
  placed: Place | undefined;
  /** The collidable that a shortcut gives a body. */
  shortcutNode: PhysicsNode | null = null;
  /** The scopes in which it watches names. */
  readonly watching = new Set<Names>();
  /** Those that hold its node, and are told when it is made again. */
  readonly users = new Set<Binding>();
  readonly uses = new Set<Binding>();
  /** Relations as last handed to the core. */
  relations: Record<string, unknown> = {};
  /** Geometry as last handed to the core for a shortcut. */
  shapes: GeometryData[] | undefined;
  /** What script set since the attribute was last written; in file units. */
  readonly #properties = new Map<string, unknown>();

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

  get units() {
    return this.scope?.units ?? SI;
  }

  // ---- values -------------------------------------------------------------------------------------------------

  /** What the author wrote for a field: by script since, else in the attribute; undefined when nothing. */
  authored(name: string): unknown {
    if (this.#properties.has(name)) return this.#properties.get(name);
    return authoredText(this.element, name, this.type);
  }

  /** All that the author wrote, in SI. */
  authoredFields(): Record<string, unknown> {
    const fields: Record<string, unknown> = {};
    for (const [name, field] of Object.entries(this.type.fields)) {
      if (holdsNodes(field)) continue;
      const value = this.authored(name);
      if (value !== undefined) fields[name] = inSI(field, value, this.units);
    }
    return fields;
  }

  /** What the author wrote for a field holds again, or its default. */
  restore(name: string): void {
    const field = this.type.fields[name];
    const ours = holdsNodes(field) && field.access !== 'outputOnly';
    const value = ours ? undefined : this.authored(name);
    if (value === undefined) this.node?.unset(name);
    else this.node?.set(name, inSI(field, value, this.units), value);
  }

  /** An attribute was written or removed. */
  attributeChanged(attributeName: string): void {
    const name = fieldsByAttribute(this.type).get(attributeName.toLowerCase());
    if (name === undefined) return this.#otherAttribute(attributeName);
    const field = this.type.fields[name];
    if (field.access === 'outputOnly') return this.restore(name);
    if (holdsNodes(field)) return this.#setNodes(name, null);
    this.#properties.delete(name);
    this.#takeBack(name);
  }

  /** It was written with what it says already: no edit, but perhaps meant as one. */
  attributeRepeated(attributeName: string): void {
    const name = fieldsByAttribute(this.type).get(attributeName.toLowerCase());
    const live = name !== undefined && this.type.fields[name].instead;
    if (live && !this.#properties.has(name)) this.restore(name);
  }

  /** Script's word is gone: that of the markup holds, or the default. */
  #takeBack(name: string): void {
    if (this.#decides(name)) this.scope?.scene.dirty(this);
    else this.restore(name);
    this.scope?.scene.valueChanged(this);
  }

  #otherAttribute(attributeName: string): void {
    if (known(this.type, attributeName)) this.scope?.scene.dirty(this);
    else if (attribute(this.element, attributeName) === null)
      this.settle('unknown-attribute', attributeName);
    else this.problem(unknownAttribute(this, attributeName));
  }

  /**
   * A property was set: the value is in file units; a joint's body may be an element or its name. Nothing, as frameworks
   * set what they no longer bind: script takes its word back.
   */
  set(name: string, value: unknown): void {
    const field = this.type.fields[name];
    if (field.access === 'outputOnly') return void this.node?.set(name, value);
    if (holdsNodes(field) && field.access !== 'inputOnly') return this.#setNodes(name, value);
    if (value === undefined || value === null) {
      if (this.#properties.delete(name)) this.#takeBack(name);
      return;
    }
    if (field.access === 'inputOnly') return this.event(name, value);
    const accepted = codecs[field.type].accept(value);
    if (accepted !== undefined || !this.node) this.#properties.set(name, accepted ?? value);
    if (this.#decides(name)) this.scope?.scene.dirty(this);
    else this.node?.set(name, inSI(field, value, this.units), value);
    this.scope?.scene.valueChanged(this);
  }

  /** Whether the node's value is not the field's own but what the plan makes of it: a place in another frame. */
  #decides(name: string): boolean {
    return this.node !== null && name in this.relations;
  }

  #setNodes(name: string, value: unknown): void {
    const before = this.named(name) ?? [];
    const given = nodesGiven(value);
    if (given === undefined) this.#properties.delete(name);
    else this.#properties.set(name, given);
    const after = this.named(name) ?? [];
    if (this.scope) noteNamed(this, before, after);
    this.scope?.scene.dirty(this);
    for (const element of [...before, ...after]) {
      const other = ownBinding(element);
      other?.scope?.scene.dirty(other);
    }
  }

  /** All that it names: those know of it while it stands in a scene. */
  get allNamed(): Element[] {
    return [...this.#properties.keys()].flatMap((name) => this.named(name) ?? []);
  }

  #namedNodes(name: string): unknown {
    const elements = this.named(name);
    return this.type.fields[name].type === 'SFNode' ? elements?.[0] : elements;
  }

  /** Elements named for a field that holds nodes; undefined: its children stand for it. */
  named(name: string): Element[] | undefined {
    return elementsAmong(this.#properties.get(name));
  }

  /** An X3D event: a ROUTE, setFieldValue. */
  event(name: string, value: unknown): void {
    const field = this.type.fields[name];
    if (field.access === 'inputOnly') return this.node?.event(name, inCore(value, this.units));
    if (holdsNodes(field)) return this.#setNodes(name, value);
    const accepted = codecs[field.type].accept(value);
    if (this.node && !this.#decides(name)) this.node.event(name, inSI(field, value, this.units));
    else if (accepted !== undefined || !this.node) this.#properties.set(name, accepted ?? value);
    if (this.#decides(name)) this.scope?.scene.dirty(this);
    this.scope?.scene.valueChanged(this);
  }

  /** The live value, or before there is a node what was asked for; a fresh copy in file units. */
  get(name: string): unknown {
    const field = this.type.fields[name];
    const body = PLACE[name] && this.#movedBy();
    if (body) return body.get(PLACE[name]);
    if (holdsNodes(field)) {
      const nodes = this.node && !isKept(field) ? this.node.get(name) : this.#namedNodes(name);
      return inPage(nodes ?? field.default, this.units);
    }
    if (this.node && !(name in this.relations))
      return inFileUnits(field, this.node.get(name), this.units);
    const codec = codecs[field.type];
    const asked = this.authored(name);
    return codec.copy(
      (asked === undefined ? undefined : codec.accept(asked)) ?? this.#defaultOf(field),
    );
  }

  /** X3D 3 had some other defaults. */
  #defaultOf(field: Field): unknown {
    return defaultOf(field, this.scope?.version ?? 4);
  }

  /** A collidable of a body is where that is. */
  #movedBy(): Binding | undefined {
    const body = this.is('CollidableShape')
      ? this.scope?.scene.drawing.bodyMoving(this.element)
      : undefined;
    return body?.node ? body : undefined;
  }

  /** Whether the author wrote any of these fields. */
  wrote(...names: string[]): boolean {
    return names.some((name) => this.authored(name) !== undefined);
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
    this.forgetTies();
    super.beginPlan();
  }

  /** Lets go of all that was noted, before it is noted anew. */
  forgetTies(): void {
    for (const other of this.uses) other.users.delete(this);
    this.uses.clear();
    for (const names of this.watching) names.unwatch(this);
    this.watching.clear();
    this.scope?.scene.readers.forget(this);
  }
}

/** A field of nodes of which the core makes nothing. */
const isKept = ({ edit, nodes, access }: Field): boolean =>
  edit === 'passive' && !nodes && access === 'inputOutput';

/** Fields of a collidable that its body decides, by the body's own. */
const PLACE: Record<string, string> = { translation: 'position', rotation: 'orientation' };

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
