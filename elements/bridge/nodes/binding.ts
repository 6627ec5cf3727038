import { codecs, SI, type PhysicsNode } from '../../../physics-core/index.js';
import { attribute, typeOf, type NodeType } from '../document/dom.js';
import { attributeOf, fieldsByAttribute, holdsNodes, inFileUnits, inSI } from './fields.js';
import type { Names } from '../document/names.js';
import type { GeometryData } from '../geometry/reader.js';
import { known, unknownAttribute } from '../document/markup.js';
import type { Scope } from '../document/scope.js';
import type { StandIn } from '../document/shortcuts.js';
import type { PageWorld } from './worlds.js';

export interface Report {
  code: string;
  severity: 'error' | 'warning' | 'info';
  message: string;
  attribute?: string;
  value?: unknown;
  used?: unknown;
}

/** The Transform that a body stands for, and what `for` says. */
export interface Place {
  transform: Element | undefined;
  name: string | null;
}

/**
 * What ties one physics element, of either spelling, to its node in the core. An element that only stands for
 * another by USE has none: `bindingOf` gives that of its DEF.
 */
export class Binding {
  readonly element: Element;
  readonly type: NodeType;
  /** Null while the element is in no `<x3d>`. */
  scope: Scope | null = null;
  world: PageWorld | null = null;
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
  #waiting = new Map<string, string>();
  /** What was reported while its node was planned: taken back when the next plan does not find it again. */
  #found = new Map<string, Report>();
  #told = this.#found;
  #planning = false;

  constructor(element: Element, type: NodeType) {
    this.element = element;
    this.type = type;
  }

  is(...names: string[]): boolean {
    return names.includes(this.type.name);
  }

  get units() {
    return this.scope?.units ?? SI;
  }

  get name(): string | undefined {
    return attribute(this.element, 'DEF') ?? attribute(this.element, 'id') ?? undefined;
  }

  // ---- values -------------------------------------------------------------------------------------------------

  /** What the author wrote for a field: by script since, else in the attribute; undefined when nothing. */
  authored(name: string): unknown {
    if (this.#properties.has(name)) return this.#properties.get(name);
    return attribute(this.element, attributeOf(name, this.type.fields[name])) ?? undefined;
  }

  /** All that the author wrote, in SI. */
  authoredFields(): Record<string, unknown> {
    const fields: Record<string, unknown> = {};
    for (const [name, field] of Object.entries(this.type.fields)) {
      if (holdsNodes(field) || field.access === 'outputOnly') continue;
      const value = this.authored(name);
      if (value !== undefined) fields[name] = inSI(field, value, this.units);
    }
    return fields;
  }

  /** An attribute was written or removed. */
  attributeChanged(attributeName: string): void {
    const name = fieldsByAttribute(this.type).get(attributeName.toLowerCase());
    if (name === undefined) return this.#otherAttribute(attributeName);
    const field = this.type.fields[name];
    this.#properties.delete(name);
    if (holdsNodes(field)) return this.scope?.scene.dirty(this);
    const text = attribute(this.element, attributeName);
    if (text === null) this.node?.unset(name);
    else this.node?.set(name, inSI(field, text, this.units), text);
    this.scope?.scene.valueChanged(this);
  }

  #otherAttribute(attributeName: string): void {
    if (known(this.type, attributeName)) this.scope?.scene.dirty(this);
    else if (attribute(this.element, attributeName) === null)
      this.settle('unknown-attribute', attributeName);
    else this.problem(unknownAttribute(this, attributeName));
  }

  /** A property was set: the value is in file units; a joint's body may be an element or its name. */
  set(name: string, value: unknown): void {
    const field = this.type.fields[name];
    if (holdsNodes(field)) {
      this.#properties.set(name, value);
      this.scope?.scene.dirty(this);
      return;
    }
    const accepted = codecs[field.type].accept(value);
    if (accepted !== undefined || !this.node) this.#properties.set(name, accepted ?? value);
    this.node?.set(name, inSI(field, value, this.units), value);
    this.scope?.scene.valueChanged(this);
  }

  /** An X3D event: a ROUTE, setFieldValue. */
  event(name: string, value: unknown): void {
    const field = this.type.fields[name];
    if (this.node) this.node.event(name, inSI(field, value, this.units));
    else this.#properties.set(name, value);
    this.scope?.scene.valueChanged(this);
  }

  /** The live value, or before there is a node what was asked for; a fresh copy in file units. */
  get(name: string): unknown {
    const field = this.type.fields[name];
    const body = PLACE[name] && this.#movedBy();
    if (body) return body.get(PLACE[name]);
    if (holdsNodes(field)) return elementsOf(this.node?.get(name) ?? field.default);
    if (this.node) return inFileUnits(field, this.node.get(name), this.units);
    const codec = codecs[field.type];
    const asked = this.authored(name);
    return codec.copy((asked === undefined ? undefined : codec.accept(asked)) ?? field.default);
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

  /** Lets go of all that was noted, before it is noted anew. */
  forgetTies(): void {
    for (const other of this.uses) other.users.delete(this);
    this.uses.clear();
    for (const names of this.watching) names.unwatch(this);
    this.watching.clear();
    this.scope?.scene.readers.forget(this);
  }

  // ---- problems -----------------------------------------------------------------------------------------------

  problem(report: Report): void {
    if (this.#planning) this.#found.set(`${report.code} ${report.attribute}`, report);
    else this.scope?.scene.report(report, this);
  }

  settle(code: string, attributeName?: string): void {
    this.scope?.scene.settle(this, attributeName, code);
  }

  /** A name that nobody bears yet. */
  waitFor(role: string, name: string): void {
    this.#waiting.set(role, name);
    const what = role === 'for' ? `"${name}"` : `${role} "${name}"`;
    this.problem({
      code: 'unknown-reference',
      severity: 'warning',
      attribute: role,
      value: name,
      used: 'nothing',
      message: `${this.label} waits for ${what}, which is not there`,
    });
  }

  /** What it waits for, by role. */
  get waiting(): ReadonlyMap<string, string> {
    return this.#waiting;
  }

  /** Forgets what it knew of its surroundings, before `plan` reads them anew. */
  beginPlan(): void {
    this.forgetTies();
    this.#waiting = new Map();
    this.#told = this.#found;
    this.#found = new Map();
  }

  /** Reads what its node is to be; what that finds wrong is told by `tellFound`. */
  plan<T>(read: () => T): T {
    this.#planning = true;
    try {
      return read();
    } finally {
      this.#planning = false;
    }
  }

  /** Reports what the plan found and takes back what it no longer found, once its node is as planned. */
  tellFound(): void {
    for (const report of this.#found.values()) this.problem(report);
    for (const [key, { code, attribute: name }] of this.#told)
      if (!this.#found.has(key)) this.settle(code, name);
    this.#told = this.#found;
  }

  /** Whether the markup as last read has this problem, whatever its node says of the field. */
  found(code: string, attributeName: string | undefined): boolean {
    return this.#found.has(`${code} ${attributeName}`);
  }

  get label(): string {
    return this.name ? `${this.type.name} "${this.name}"` : this.type.name;
  }
}

/** Fields of a collidable that its body decides, by the body's own. */
const PLACE: Record<string, string> = { translation: 'position', rotation: 'orientation' };

/** Nodes as a page sees them: their elements. */
function elementsOf(value: unknown): unknown {
  if (Array.isArray(value)) return value.map(elementsOf);
  const host = (value as PhysicsNode | null)?.host;
  return host instanceof Element ? host : value;
}

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
