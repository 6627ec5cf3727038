import { Emitter, type Listener } from '../emitter.js';
import { codecs } from '../fields/values.js';
import type { Value } from '../fields/types.js';
import { guards } from '../guards.js';
import type { ProblemReport } from '../problems.js';
import type { World } from '../world/world.js';
import type { CollectionNode } from './rigid-body-collection.js';
import type { Field, NodeType } from './table.js';

export interface NodeContext {
  world: World;
  type: NodeType;
  id: number;
  /** Whatever stands for the node outside: its element in a page. Problems name it. */
  host: unknown;
  name: string | undefined;
  collection: CollectionNode | undefined;
}

/** A plain-data value with a `type`, from which a node is made. */
export interface NodeData {
  type: string;
  [field: string]: unknown;
}

/**
 * One X3D physics node: what its author asked for, and the Bullet object behind it. The tables say what each field
 * does; subclasses say how the object is made and unmade.
 */
export class PhysicsNode {
  readonly world: World;
  readonly type: NodeType;
  readonly id: number;
  readonly host: unknown;
  name: string | undefined;
  collection: CollectionNode | undefined;
  removed = false;
  /** Nodes made from plain data given to a field; they live and die with this one. */
  readonly #children = new Map<string, PhysicsNode[]>();
  readonly #asked = new Map<string, Value>();
  readonly #authored = new Set<string>();
  /** What the author had asked for where an event has come since; undefined: nothing. */
  readonly #beforeEvent = new Map<string, Value | undefined>();
  readonly #emitter = new Emitter();
  #changed = new Set<string>();
  #built = false;

  constructor(context: NodeContext) {
    this.world = context.world;
    this.type = context.type;
    this.id = context.id;
    this.host = context.host ?? this;
    this.name = context.name;
    this.collection = context.collection;
  }

  /** Whether its object stands in the running world. */
  get built(): boolean {
    return this.#built;
  }

  // ---- fields -------------------------------------------------------------------------------------------------

  /** The author's own value, or X3D's default. */
  asked<T = Value>(name: string): T {
    return (this.#asked.has(name) ? this.#asked.get(name) : this.type.fields[name]!.default) as T;
  }

  /** Whether the author wrote this field, in markup or since. */
  authored(name: string): boolean {
    return this.#authored.has(name);
  }

  /** The live value where the simulation changes it, else what was asked for; always a fresh copy, in SI units. */
  get(name: string): Value {
    const field = this.#field(name);
    if (!field) return undefined;
    // A node that was just added is built now, so that it does not answer with defaults.
    if (field.read) this.world.flush();
    if (field.read && this.#built) return field.read(this as never);
    return codecs[field.type].copy(this.asked(name));
  }

  /** Asks for a value. Equal to the one last asked for: nothing happens. `text`: how the author wrote it. */
  set(name: string, value: unknown, text: unknown = value): void {
    const field = this.#writable(name);
    if (!field) return;
    const accepted = this.#accept(name, field, value, text);
    if (accepted === undefined) return;
    const same = codecs[field.type].equal(accepted, this.#lastAsked(name, field));
    if (same && (this.#authored.has(name) || field.read)) {
      this.#authored.add(name);
      return;
    }
    this.#beforeEvent.delete(name);
    this.#take(name, accepted);
  }

  /** The author's last word: what events did since does not make the same word an edit. */
  #lastAsked(name: string, field: Field): Value {
    if (!this.#beforeEvent.has(name)) return this.asked(name);
    const said = this.#beforeEvent.get(name);
    return said === undefined ? field.default : said;
  }

  /** An X3D event (ROUTE, setFieldValue): acts even where the value is the one last asked for. */
  event(name: string, value: unknown): void {
    const field = this.#writable(name);
    if (!field) return;
    if (field.access === 'initializeOnly') {
      this.report({
        code: 'bad-access',
        severity: 'warning',
        attribute: name,
        value,
        used: this.asked(name),
        message: `${this.label}: ${name} is initializeOnly and takes no events; edit the attribute instead`,
      });
      return;
    }
    const accepted = this.#accept(name, field, value, value);
    if (accepted === undefined) return;
    if (!this.#beforeEvent.has(name))
      this.#beforeEvent.set(name, this.#authored.has(name) ? this.asked(name) : undefined);
    this.#take(name, accepted);
  }

  /** The attribute was removed: X3D's default again. */
  unset(name: string): void {
    const field = this.type.fields[name];
    if (!field) return;
    this.world.settle(this, name);
    this.#beforeEvent.delete(name);
    if (!this.#authored.delete(name)) return;
    this.#asked.delete(name);
    this.#adopt(name, field, field.default);
    this.touch(name);
  }

  /** Back to the author's own values: what events did is undone. */
  forgetEvents(): void {
    for (const [name, said] of this.#beforeEvent) {
      if (said === undefined) this.unset(name);
      else this.#take(name, said);
    }
    this.#beforeEvent.clear();
  }

  #field(name: string): Field | undefined {
    const field = this.type.fields[name] as Field | undefined;
    if (!field) {
      this.report({
        code: 'unknown-attribute',
        severity: 'warning',
        attribute: name,
        message: `${this.label} has no field ${name}`,
      });
    }
    return field;
  }

  #writable(name: string): Field | undefined {
    const field = this.#field(name);
    if (field?.access !== 'outputOnly') return field;
    this.report({
      code: 'bad-access',
      severity: 'warning',
      attribute: name,
      message: `${this.label}: ${name} is an output and can't be set`,
    });
    return undefined;
  }

  #take(name: string, value: Value): void {
    this.#asked.set(name, this.#adopt(name, this.type.fields[name]!, value));
    this.#authored.add(name);
    if (this.type.fields[name]!.unsimulated) this.#reportUnsimulated(name, value);
    this.touch(name);
  }

  #reportUnsimulated(name: string, value: Value): void {
    this.report({
      code: 'approximated-field',
      severity: 'warning',
      attribute: name,
      value,
      used: 'nothing',
      message: `${this.label}: ${name} is kept but not simulated yet`,
    });
  }

  /** The valid value, or undefined after a report: a value that can't be used never reaches Bullet. */
  #accept(name: string, field: Field, value: unknown, text: unknown): Value | undefined {
    const used = this.asked(name);
    const codec = codecs[field.type];
    const accepted = guards.wellFormed(codec, value);
    const named = field.values?.includes(accepted as string) ?? true;
    if (accepted === undefined || !named) {
      const expected = field.values ? field.values.join(', ') : field.type;
      this.report({
        code: 'bad-value',
        severity: 'warning',
        attribute: name,
        value: text,
        used,
        message: `${this.label}: ${name}="${show(text)}" is not ${expected}; ${show(used)} is used`,
      });
      return undefined;
    }
    return this.#inRange(name, field, accepted, text, used);
  }

  #inRange(
    name: string,
    field: Field,
    value: Value,
    text: unknown,
    used: Value,
  ): Value | undefined {
    if (guards.inRange(field, value)) {
      this.world.settle(this, name);
      return value;
    }
    const [low, high] = field.range!;
    const clamps = Number.isFinite(low) && Number.isFinite(high);
    const clamp = (number: number): number => Math.min(high, Math.max(low, number));
    const kept = clamps
      ? Array.isArray(value)
        ? value.map(clamp)
        : clamp(value as number)
      : undefined;
    this.report({
      code: 'out-of-range',
      severity: 'warning',
      attribute: name,
      value: text,
      used: kept ?? used,
      message: `${this.label}: ${name}="${show(text)}" is outside ${field.open ? '(' : '['}${low}, ${high}]; ${show(kept ?? used)} is used`,
    });
    return kept;
  }

  /** Plain data in a node field becomes nodes of our own. */
  #adopt(name: string, field: Field, value: Value): Value {
    if (!field.nodes) return value;
    for (const child of this.#children.get(name) ?? []) child.remove();
    const made: PhysicsNode[] = [];
    const node = (item: unknown): unknown => {
      if (item instanceof PhysicsNode || item === null || typeof item !== 'object') return item;
      const child = this.world.addData(item as NodeData, this, field.nodes!);
      if (child instanceof PhysicsNode) made.push(child);
      return child;
    };
    const adopted = Array.isArray(value) ? value.map(node).filter(Boolean) : node(value);
    this.#children.set(name, made);
    return adopted;
  }

  // ---- life ---------------------------------------------------------------------------------------------------

  /** Notes that a field changed; the world applies it in one batch before the next step. */
  touch(name: string): void {
    this.#changed.add(name);
    this.world.enqueue(this);
  }

  /** Applies what changed: creates the object, makes it again, or patches it. */
  apply(): void {
    const changed = this.#changed;
    this.#changed = new Set();
    if (this.removed) return;
    if (!this.#built) {
      this.#make();
      return;
    }
    const fields = [...changed]
      .map((name) => this.type.fields[name])
      .filter((field) => field !== undefined);
    if (fields.some((field) => field.edit === 'rebuild')) {
      this.unmake();
      this.#make();
      return;
    }
    const patches = new Set(
      fields.map((field) => field.patch).filter((patch) => patch !== undefined),
    );
    for (const patch of patches) patch(this as never);
    this.world.counts.patched += fields.length;
  }

  #make(): void {
    if (!this.create()) return;
    this.#built = true;
    this.world.counts.created++;
    const patches = new Set(Object.values(this.type.fields).map((field) => field.patch));
    for (const patch of patches) patch?.(this as never);
    this.created();
  }

  /** Takes the object out of Bullet; the node and what was asked of it stay. */
  unmake(): void {
    if (!this.#built) return;
    this.#built = false;
    this.world.counts.destroyed++;
    this.destroy();
  }

  /** Makes the object. False: something it needs is not there yet, try at the next change. */
  protected create(): boolean {
    return true;
  }

  /** After creation and the first patches. */
  protected created(): void {}

  protected destroy(): void {}

  /** Takes the node out of its world for good. */
  remove(): void {
    if (this.removed) return;
    this.removed = true;
    this.unmake();
    for (const children of this.#children.values()) for (const child of children) child.remove();
    this.released();
    this.world.forget(this);
  }

  /** Lets go of other nodes. */
  protected released(): void {}

  // ---- events and problems --------------------------------------------------------------------------------------

  /** Calls `listener` with the event's detail; returns how to stop it. */
  on(event: string, listener: Listener): () => void {
    return this.#emitter.on(event, listener);
  }

  heard(event: string): boolean {
    return this.#emitter.heard(event);
  }

  emit(event: string, detail: unknown): void {
    this.#emitter.emit(event, detail);
  }

  report(report: ProblemReport): void {
    this.world.report(report, this);
  }

  /** How messages call it. */
  get label(): string {
    return this.name ? `${this.type.name} "${this.name}"` : this.type.name;
  }
}

/** A value in a message: short. */
function show(value: unknown): string {
  const text = Array.isArray(value) ? value.flat().join(' ') : String(value);
  return text.length > 60 ? `${text.slice(0, 57)}…` : text;
}
