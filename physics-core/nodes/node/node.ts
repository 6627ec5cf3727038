import type { Chunk } from '../../base/chunk.js';
import { Emitter, type Listener } from '../../base/emitter.js';
import { codecs } from '../../fields/values.js';
import type { Value } from '../../fields/types.js';
import type { ProblemReport } from '../../base/problems.js';
import { fieldOf } from './accept.js';
import { Children } from './children.js';
import type { SimulationNode } from '../../dynamics/node.js';
import { contactReader } from '../../effects/contacts/effects.js';
import { contacts } from '../../effects/effect/chunks.js';
import type { NodeData } from './node-data.js';
import type { NodeContext, NodeWorld } from './node-world.js';
import { FieldEdits, type EditedNode } from './field-edits.js';
import { FieldState } from './field-state.js';
import { defaultOf, fieldName, type Field, type NodeType } from './table.js';

const COLLISION_EVENTS = ['collisionstart', 'collisionend'];

/**
 * One X3D physics node: what its author asked for, and the Bullet object behind it. The tables say what each field
 * does; subclasses say how the object is made and unmade.
 */
export class PhysicsNode implements SimulationNode, EditedNode {
  readonly world: NodeWorld;
  readonly type: NodeType;
  readonly id: number;
  readonly host: unknown;
  name: string | undefined;
  /** The RigidBodyCollection that it belongs to. */
  collection: PhysicsNode | undefined;
  readonly version: number;
  removed = false;
  readonly children = new Children<PhysicsNode>(this);
  /** What its author said and events said since. */
  readonly fieldState = new FieldState();
  readonly #edits = new FieldEdits(this);
  readonly #emitter = new Emitter();
  #changed = new Set<string>();
  /** Those of them that its author or an event changed; the others follow from edits of other nodes. */
  #edited = new Set<string>();
  #built = false;

  constructor(context: NodeContext) {
    this.world = context.world;
    this.type = context.type;
    this.id = context.id;
    this.host = context.host ?? this;
    this.name = context.name;
    this.collection = context.collection;
    this.version = context.version ?? 4;
    // As elements are upgraded: the node that is there already becomes one of this class, with all that it has.
    if (context.early) return Object.setPrototypeOf(context.early, new.target.prototype) as this;
  }

  /** A setting of its collection is another. */
  collectionChanged?(): void;

  /** The same node on another thread told something. False: that was told here before. */
  toldElsewhere?(event: string, detail: unknown): boolean;

  /** Whether it is an author's node, and so shows in `stats`. */
  protected get counted(): boolean {
    return true;
  }

  /** Whether its object stands in the running world. */
  get built(): boolean {
    return this.#built;
  }

  // ---- fields -------------------------------------------------------------------------------------------------

  /** The author's own value, or X3D's default. */
  asked<T = Value>(name: string): T {
    return (
      this.fieldState.asked.has(name) ? this.fieldState.asked.get(name) : this.defaultOf(name)
    ) as T;
  }

  defaultOf(name: string): Value {
    return defaultOf(this.type.fields[name]!, this.version);
  }

  /** Whether the author wrote this field, in markup or since. */
  authored(name: string): boolean {
    return this.fieldState.authored.has(name);
  }

  /** The live value where the simulation changes it, else what was asked for; always a fresh copy, in SI units. */
  get(spelling: string): Value {
    const name = fieldName(this.type, spelling);
    const field = fieldOf(this, name);
    if (!field) return undefined;
    // A node that was just added is built now, so that it does not answer with defaults.
    if (field.read) this.world.flush();
    if (field.read && this.#built) return field.read(this);
    return codecs[field.type].copy(this.asked(name));
  }

  /** Asks for a value. Equal to the one last asked for: nothing happens. `text`: how the author wrote it. */
  set(spelling: string, value: unknown, text: unknown = value): void {
    this.world.events.call(this, 'set', [spelling, value], () =>
      this.#edits.set(spelling, value, text),
    );
  }

  /** An X3D event (ROUTE, setFieldValue): acts even where the value is the one last asked for. */
  event(spelling: string, value: unknown): void {
    this.world.events.call(this, 'event', [spelling, value], () =>
      this.#edits.event(spelling, value),
    );
  }

  /** The attribute was removed: X3D's default again. */
  unset(spelling: string): void {
    this.world.events.call(this, 'unset', [spelling], () => this.#edits.unset(spelling));
  }

  /** Takes over what a snapshot holds. */
  load(state: FieldState): void {
    this.#edits.load(state);
  }

  /** Back to the author's own values: what events did is undone. */
  forgetEvents(): void {
    this.#edits.forgetEvents();
  }

  /** Whether an edit of a field waits to be applied. */
  waits(name: string): boolean {
    return this.#changed.has(name);
  }

  /** Its author or an event changed a field. */
  edited(name: string): void {
    this.#edited.add(name);
    this.touch(name);
  }

  // ---- children ---------------------------------------------------------------------------------------------------

  isNode(item: unknown): item is PhysicsNode {
    return item instanceof PhysicsNode;
  }

  makeChild(data: NodeData, types: readonly string[]): PhysicsNode | undefined {
    return this.world.store.addData(data, this, types);
  }

  /** Code that it is neither made nor patched without. */
  get needs(): Chunk<unknown>[] {
    const { type } = this;
    return [type.chunk, ...(type.needs?.(this) ?? [])].filter((chunk) => chunk !== undefined);
  }

  // ---- life ---------------------------------------------------------------------------------------------------

  /** Notes that a field changed; the world applies it in one batch before the next step. */
  touch(name: string): void {
    this.#changed.add(name);
    this.world.store.changed(this);
  }

  /** Applies what changed: creates the object, makes it again, or patches it. */
  apply(): void {
    const changed = this.#changed;
    const edits = this.#edited.size;
    this.#changed = new Set();
    this.#edited = new Set();
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
    this.#patch(fields);
    if (this.counted) this.world.counts.patched += edits;
  }

  #make(): void {
    if (!this.create()) return;
    this.#built = true;
    if (this.counted) this.world.counts.created++;
    this.#patch(Object.values(this.type.fields));
    this.created();
  }

  /** Fields that act together share a patch, which is called once. */
  #patch(fields: readonly Field[]): void {
    const patches = new Set(fields.map((field) => field.patch));
    for (const patch of patches) patch?.(this);
  }

  /** Takes the object out of Bullet; the node and what was asked of it stay. */
  unmake(): void {
    if (this.#built) this.abandon();
  }

  /** The same, however far its making came. */
  abandon(): void {
    if (this.#built && this.counted) this.world.counts.destroyed++;
    this.#built = false;
    this.destroy();
  }

  /** Makes the object. False: something it needs is not there yet, try at the next change. */
  protected create(): boolean {
    return true;
  }

  /** After creation and the first patches. */
  protected created(): void {}

  /** It may have been made in part only. */
  protected destroy(): void {}

  /** Takes the node out of its world for good. */
  remove(): void {
    if (!this.removed) this.world.events.call(this, 'remove', [], () => this.#remove());
  }

  #remove(): void {
    this.removed = true;
    this.unmake();
    this.children.remove();
    this.world.store.forget(this);
    this.released();
    // It may still be listened to.
    this.world.registry.find(contactReader)?.release(this);
  }

  /** It stands in another collection of its world now. */
  belongTo(collection: PhysicsNode | undefined): void {
    this.world.events.call(this, 'belongTo', [collection], () => {
      this.collection = collection;
    });
  }

  /** Lets go of other nodes. */
  protected released(): void {}

  // ---- events and problems --------------------------------------------------------------------------------------

  /** Calls `listener` with the event's detail; returns how to stop it. */
  on(event: string, listener: Listener): () => void {
    const stop = this.#emitter.on(event, listener);
    this.#listened(event);
    return () => {
      stop();
      this.#listened(event);
    };
  }

  #listened(event: string): void {
    this.listenersChanged(event);
    this.world.events.listened(this, event);
  }

  /** Nothing is computed for an event that nobody listens to. */
  protected listenersChanged(event: string): void {
    if (!COLLISION_EVENTS.includes(event)) return;
    const { registry: effects } = this.world;
    const heard = contacts.here && this.heard(event);
    const reader = heard ? effects.get(contactReader) : effects.find(contactReader);
    reader?.update(this);
  }

  /** Code of effects is here that may not have been when somebody began to listen. */
  codeCame(): void {
    for (const event of COLLISION_EVENTS) if (this.heard(event)) this.listenersChanged(event);
  }

  heard(event: string): boolean {
    return this.#emitter.heard(event);
  }

  get heardEvents(): string[] {
    return this.#emitter.events;
  }

  /** Tells those who listen, as soon as what is under way is over. */
  emit(event: string, detail: unknown): void {
    const { events } = this.world;
    if (!events.silent) events.tell(this.#emitter, event, detail);
  }

  /** Whether it touches another; known while somebody listens to its collisions. */
  get colliding(): boolean {
    return this.world.registry.find(contactReader)?.colliding(this) ?? false;
  }

  report(report: ProblemReport): void {
    this.world.report(report, this);
  }

  /** Takes back what it reported of an attribute, or by a code. */
  settle(attribute?: string, code?: string): void {
    this.world.settle(this, attribute, code);
  }

  /** Reports as long as something is the case, and settles it when it is no more. */
  reportWhile(is: boolean, report: ProblemReport): void {
    if (is) this.report(report);
    else this.settle(report.attribute, report.code);
  }

  /** How messages call it. */
  get label(): string {
    return this.name ? `${this.type.name} "${this.name}"` : this.type.name;
  }
}
