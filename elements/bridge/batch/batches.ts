import type { X3DDocument, X3DNode } from '../x3dom/x3dom.js';
import type { Target } from '../drawing/drawing.js';
import type { Binding } from '../nodes/binding.js';
import type { X3DBounded, X3DDrawnDocument, X3DTransform } from '../x3dom/renderer.js';
import { Batch } from './batch.js';
import { Group } from './group.js';
import { LEAST } from './least.js';
import { Looks } from './look.js';
import { ManyRenderer } from './many.js';
import { Member } from './member.js';
import { hastenTicks, Resting } from './ticks.js';
import { Watch } from './watch.js';

/** Frames that a running mean is of. */
const MEAN = 60;

/** Members that look alike and stand in one group. */
interface Kind {
  readonly members: Set<Member>;
  batch?: Batch | undefined;
  /** The last one has left. */
  readonly end: () => void;
}

/** All bodies of one document, and which of them are drawn in one call. */
export class Batches {
  readonly document: X3DDocument;
  readonly #renderer: ManyRenderer;
  readonly #onfail: (why: string) => void;
  readonly #members = new Map<X3DNode, Member>();
  /** Those that may be drawn otherwise by now. */
  readonly #changed = new Set<Member>();
  readonly #watch = new Watch(this.#members, (member) => this.#touched(member));
  readonly #groups = new WeakMap<X3DNode, Group>();
  readonly #kinds = new WeakMap<X3DNode, Map<string, Kind>>();
  readonly #kindOf = new Map<Member, Kind>();
  readonly #looks = new Looks();
  readonly #resting: Resting;
  /** What draws now. */
  readonly all = new Set<Batch>();
  /** Milliseconds per frame to find out what changed. */
  ms = 0;

  constructor(document: X3DDocument, onfail: (why: string) => void) {
    this.document = document;
    this.#onfail = onfail;
    this.#renderer = new ManyRenderer(document as X3DDrawnDocument, () => this.#beforeFrame());
    hastenTicks();
    this.#resting = new Resting(document as X3DDrawnDocument);
  }

  /** A Transform that a body moves came, or is to be looked at anew. */
  note(transform: X3DNode, target: Target, body: Binding, allowed: boolean): void {
    let member = this.#members.get(transform);
    if (!member) this.#members.set(transform, (member = new Member(transform as X3DTransform)));
    member.body = body;
    member.allowed = allowed;
    member.isTargetOf(target);
    this.#touched(member);
    // What stands above it is not its own any more.
    for (let [above] = transform._parentNodes; above; [above] = above._parentNodes) {
      const outer = this.#members.get(above);
      if (outer) this.#touched(outer);
    }
  }

  #touched(member: Member): void {
    member.detach();
    this.#changed.add(member);
  }

  memberOf(transform: X3DNode): Member | undefined {
    return this.#members.get(transform);
  }

  /** What it is drawn by. */
  batchOf(member: Member): Batch | undefined {
    return this.#kindOf.get(member)?.batch;
  }

  // ---- frames -----------------------------------------------------------------------------------------------------

  /** Nothing of it may be otherwise when x3dom draws. */
  #beforeFrame(): void {
    const start = performance.now();
    if (this.#renderer.failure !== undefined) this.#undo(this.#renderer.failure);
    else if (this.#changed.size > 0) this.#renderer.attempt(() => this.#update());
    this.ms += (performance.now() - start - this.ms) / MEAN;
  }

  #update(): void {
    for (const member of [...this.#changed]) {
      if (member.gone) this.#forget(member);
      else this.#sort(member);
    }
    this.#looks.forget();
    // What was found out just now is no change.
    this.#changed.clear();
  }

  #undo(why: string): void {
    for (const kind of new Set(this.#kindOf.values())) this.#dissolve(kind);
    this.#members.clear();
    this.#kindOf.clear();
    this.#renderer.unhook();
    this.#onfail(why);
  }

  // ---- who is drawn with whom -------------------------------------------------------------------------------------

  #sort(member: Member): void {
    const before = this.#kindOf.get(member);
    member.read((node) => this.#members.has(node));
    this.#watch.begin(member);
    const kind = member.why === undefined ? this.#kind(member) : undefined;
    if (kind === before && member.isAsTaken) return before?.batch?.reread(member);
    this.#leave(member);
    if (kind) this.#join(member, kind);
  }

  #kind({ parent, shape }: Member): Kind {
    const kinds = this.#kinds.get(parent!) ?? new Map<string, Kind>();
    this.#kinds.set(parent!, kinds);
    const look = this.#looks.of(shape!);
    const end = (): void => void kinds.delete(look);
    const kind = kinds.get(look) ?? { members: new Set(), end };
    kinds.set(look, kind);
    return kind;
  }

  #join(member: Member, kind: Kind): void {
    this.#kindOf.set(member, kind);
    kind.members.add(member);
    if (kind.batch) kind.batch.add(member);
    else if (kind.members.size >= LEAST) this.#form(kind, member.parent!);
  }

  #form(kind: Kind, parent: X3DBounded): void {
    const group = this.#groups.get(parent) ?? new Group(parent);
    this.#groups.set(parent, group);
    kind.batch = new Batch(this.#renderer, group, this.#resting);
    this.all.add(kind.batch);
    for (const member of kind.members) kind.batch.add(member);
  }

  #leave(member: Member): void {
    const kind = this.#kindOf.get(member);
    if (!kind) return;
    this.#kindOf.delete(member);
    kind.members.delete(member);
    kind.batch?.remove(member);
    // Not at once where one is missing: it may be back in the next frame.
    if (kind.members.size < LEAST / 2) this.#dissolve(kind);
    if (kind.members.size === 0) kind.end();
  }

  #dissolve(kind: Kind): void {
    const { batch } = kind;
    kind.batch = undefined;
    if (batch) this.all.delete(batch);
    for (const member of [...(batch?.members ?? [])]) batch!.remove(member);
  }

  #forget(member: Member): void {
    this.#members.delete(member.transform);
    this.#leave(member);
  }
}
