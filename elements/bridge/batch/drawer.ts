import { collectionOf } from '../document/structure.js';
import type { Target } from '../drawing/drawing.js';
import type { Binding } from '../nodes/binding.js';
import type { PageWorld } from '../nodes/surroundings.js';
import { attribute } from '../words/dom.js';
import { nodeOf, type X3DDocument, type X3DNode } from '../x3dom/x3dom.js';
import { Batches } from './batches.js';
import { DrawnWorld, type Drawn, type DrawnBody } from './drawn-world.js';

/** The `<x3d>` whose bodies are drawn. */
export interface DrawnScene {
  readonly document: X3DDocument | undefined;
  readonly drawing: { targetsOf(body: Binding): readonly Target[] };
  bindings(): Iterable<Binding>;
  requestRender(): void;
}

/** Draws the bodies of one `<x3d>`, those that look alike in one call. */
export class Drawer implements Drawn {
  readonly #scene: DrawnScene;
  /** Of what x3dom read last: it may read the `<x3d>` again. */
  #batches: Batches | undefined;
  #failed = false;
  /** Collections that say no. */
  readonly #unbatched = new WeakSet<Binding>();
  readonly bytes: number;

  constructor(scene: DrawnScene, bytes: number) {
    this.#scene = scene;
    this.bytes = bytes;
    for (const collection of scene.bindings()) this.#isUnbatched(collection);
    this.#noteAll();
  }

  /** What a node of the core is made of changed. */
  nodeChanged(binding: Binding): void {
    if (!binding.is('RigidBodyCollection')) return;
    if (this.#unbatched.has(binding) !== this.#isUnbatched(binding)) this.#noteAll();
  }

  #isUnbatched(collection: Binding): boolean {
    const unbatched = saysNo(collection.element);
    if (unbatched) this.#unbatched.add(collection);
    else this.#unbatched.delete(collection);
    return unbatched;
  }

  #noteAll(): void {
    for (const body of this.#scene.bindings())
      for (const target of this.#scene.drawing.targetsOf(body)) {
        const node = nodeOf(target.element);
        if (node) this.note(node, target, body);
      }
    this.#scene.requestRender();
  }

  note(node: X3DNode, target: Target, body: Binding): void {
    const { document } = this.#scene;
    if (!document || this.#failed) return;
    if (document !== this.#batches?.document)
      this.#batches = new Batches(document, (why) => this.#fail(why, body));
    this.#batches.note(node, target, body, mayBeBatched(node, body));
    if (body.world) body.world.drawing ??= new DrawnWorld(this, body.world);
  }

  // ---- what the page may ask --------------------------------------------------------------------------------------

  get ms(): number {
    return this.#batches?.ms ?? 0;
  }

  /** Asked in every frame by some: the page is not searched for bodies. */
  count(world: PageWorld): { batches: number; drawsSaved: number } {
    const counts = { batches: 0, drawsSaved: 0 };
    for (const { members } of this.#batches?.all ?? []) {
      let own = 0;
      for (const { body } of members) if (body.world === world) own++;
      if (own === 0) continue;
      counts.batches++;
      counts.drawsSaved += own - 1;
    }
    return counts;
  }

  *bodies(): Generator<DrawnBody> {
    for (const body of this.#scene.bindings()) {
      const drawn = this.of(body);
      if (drawn) yield drawn;
    }
  }

  of(body: Binding): DrawnBody | undefined {
    for (const { element } of this.#scene.drawing.targetsOf(body)) {
      const node = nodeOf(element);
      const member = node && this.#batches?.memberOf(node);
      if (!member) continue;
      const batch = this.#batches!.batchOf(member);
      return { body, batch, size: batch?.members.length ?? 1, why: member.why };
    }
    return undefined;
  }

  #fail(why: string, { world }: Binding): void {
    this.#failed = true;
    world?.report({
      code: 'drawing-plain',
      severity: 'info',
      value: why,
      used: 'x3dom, body by body',
      message: `bodies that look alike are drawn one by one: ${why}`,
    });
  }
}

const saysNo = (element: Element): boolean =>
  attribute(element, 'batch')?.trim().toLowerCase() === 'false';

/** Unless `batch="false"` says no: at the body, its collection or one of its Shapes. */
function mayBeBatched({ _childNodes }: X3DNode, body: Binding): boolean {
  const collection = body.scope ? collectionFor(body) : undefined;
  const parts = [..._childNodes.map(({ _xmlNode }) => _xmlNode), body.element, collection?.element];
  return !parts.some((element) => element && saysNo(element));
}

/** A body outside any collection goes by that of the default world. */
function collectionFor(body: Binding): Binding | undefined {
  const { worlds } = body.scene!;
  return (
    collectionOf(body) ?? (worlds.isDefault(body.world) ? worlds.defaultCollection() : undefined)
  );
}
