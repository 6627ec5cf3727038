import type { BodyNode } from '../nodes/body.js';
import { nodeTypes } from '../nodes/index.js';
import { isGeometry } from '../shapes/geometry.js';
import type { NodeData } from '../nodes/children.js';
import type { PhysicsNode } from '../nodes/node.js';
import type { CollectionNode } from '../nodes/rigid-body-collection.js';
import { show } from '../base/show.js';
import { Edits } from './edits.js';
import { Reporting, type Console } from './reporting.js';
import type { AddOptions } from './types.js';

/** The nodes of a world in the order they were added, and the edits of them that Bullet has not seen yet. */
export abstract class NodeWorld extends Reporting {
  protected readonly edits = new Edits();
  readonly #nodes = new Set<PhysicsNode>();
  readonly #collections = new Set<CollectionNode>();
  /** X3D's defaults, for a world without a collection. */
  readonly #defaults: CollectionNode;
  #nextId = 1;
  /** Tells the page's loop that there is work again. */
  onwork?: () => void;

  constructor(log: Console) {
    super(log);
    this.#defaults = this.make('RigidBodyCollection', {}) as CollectionNode;
  }

  get nodes(): Iterable<PhysicsNode> {
    return this.#nodes;
  }

  /** Adds a node of an X3D type. Field values are X3D's, in SI units; nodes may be given as nodes or plain data. */
  add(type: string, fields: Record<string, unknown> = {}, options: AddOptions = {}): PhysicsNode {
    if (!nodeTypes[type]) throw new TypeError(`x3d-physics has no node type ${show(type)}`);
    return this.events.during(() => this.#add(type, fields, options));
  }

  #add(type: string, fields: Record<string, unknown>, options: AddOptions): PhysicsNode {
    const node = this.make(type, options);
    this.#nodes.add(node);
    if (type === 'RigidBodyCollection') this.#collections.add(node as CollectionNode);
    if (type === 'RigidBody' && options.start) (node as BodyNode).start = options.start;
    for (const [name, value] of Object.entries(fields)) node.set(name, value);
    this.enqueue(node);
    return node;
  }

  /** A node of the world's own, which authors don't find. */
  make(type: string, options: AddOptions): PhysicsNode {
    const nodeType = nodeTypes[type]!;
    const id = options.id ?? this.#nextId;
    this.#nextId = Math.max(this.#nextId, id + 1);
    return nodeType.make({
      world: this as never,
      type: nodeType,
      id,
      host: options.host,
      name: options.name,
      collection: options.collection as CollectionNode | undefined,
      version: options.version,
    });
  }

  /** A node from plain data in a field that takes `types`: for bare geometry a CollidableShape; undefined: it takes none such. */
  addData(data: NodeData, parent: PhysicsNode, types: readonly string[]): PhysicsNode | undefined {
    const { type, ...fields } = data;
    const options = {
      collection: parent.collection,
      host: parent.host === parent ? undefined : parent.host,
      version: parent.version,
    };
    if (types.includes(type)) return this.add(type, fields, options);
    if (types.includes('CollidableShape') && isGeometry(type))
      return this.add('CollidableShape', { shape: [data] }, options);
    return undefined;
  }

  /** The node with this DEF, id, or host; the last one where several have it. */
  node(nameOrHost: unknown): PhysicsNode | undefined {
    let found: PhysicsNode | undefined;
    if (nameOrHost === undefined || nameOrHost === null) return found;
    for (const node of this.#nodes)
      if ([node.name, node.host, node.id].includes(nameOrHost)) found = node;
    return found;
  }

  forget(node: PhysicsNode): void {
    this.#nodes.delete(node);
    this.#collections.delete(node as CollectionNode);
    this.edits.drop(node);
    this.takeBack(node);
    this.work();
  }

  /** Settings of the world: its first collection's, or X3D's defaults. */
  get settings(): CollectionNode {
    for (const collection of this.#collections) return collection;
    return this.#defaults;
  }

  /** The RigidBodyCollections that share this world. */
  get rigidBodyCollections(): Iterable<CollectionNode> {
    return this.#collections;
  }

  /** Tells where later collections of a shared world say something else than the first. */
  compareCollections(): void {
    for (const collection of this.#collections) collection.compareWith(this.settings);
  }

  /** The world is its first RigidBodyCollection. */
  get(field: string): unknown {
    return this.settings.get(field);
  }

  set(field: string, value: unknown): void {
    if (this.#collections.size === 0) this.add('RigidBodyCollection');
    this.settings.set(field, value);
  }

  enqueue(node: PhysicsNode): void {
    if (node === this.#defaults) return;
    this.edits.add(node);
    this.work();
  }

  work(): void {
    this.onwork?.();
  }

  /** Whether edits wait for the next step or frame. */
  get pending(): boolean {
    return this.edits.pending;
  }
}
