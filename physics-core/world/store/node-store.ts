import { PhysicsNode } from '../../nodes/node/node.js';
import type { NodeDefinition } from '../../nodes/node/define.js';
import type { NodeData } from '../../nodes/node/node-data.js';
import type { NodeWorld } from '../../nodes/node/node-world.js';
import type { Editing } from './editing.js';
import { BodyNode } from '../../nodes/body/body.js';
import { nodeTypes } from '../../nodes/index.js';
import { lateTypes } from '../../nodes/late.js';
import { CollectionNode } from '../../nodes/collection-node.js';
import { isGeometry } from '../../shapes/geometry.js';
import { show } from '../../base/show.js';
import type { AddOptions } from './types.js';

/** The world whose nodes these are. */
interface StoreWorld extends NodeWorld {
  readonly edits: Editing;
  add(type: string): PhysicsNode;
}

/** The nodes of a world in the order they were added. */
export class NodeStore {
  readonly #world: StoreWorld;
  readonly #nodes = new Set<PhysicsNode>();
  readonly #collections = new Set<CollectionNode>();
  /** Those that were made before the code of their class was here. */
  readonly #early = new Set<PhysicsNode>();
  /** X3D's defaults, for a world without a collection. */
  readonly defaults: PhysicsNode;
  /** The number of the next node. */
  nextId = 1;

  constructor(world: StoreWorld) {
    this.#world = world;
    this.defaults = this.#make(nodeTypes.RigidBodyCollection!, {});
  }

  get all(): Iterable<PhysicsNode> {
    return this.#nodes;
  }

  /** The RigidBodyCollections that share this world. */
  get collections(): ReadonlySet<CollectionNode> {
    return this.#collections;
  }

  /** The collection that settings are set on, made where there is none. */
  firstCollection(): PhysicsNode {
    return this.#collections.size > 0 ? this.settings : this.#world.add('RigidBodyCollection');
  }

  /** Settings of the world: its first collection's, or X3D's defaults. */
  get settings(): PhysicsNode {
    for (const collection of this.#collections) return collection;
    return this.defaults;
  }

  add(type: string, fields: Record<string, unknown>, options: AddOptions): PhysicsNode {
    const nodeType = nodeTypes[type] ?? lateTypes[type];
    if (!nodeType) throw new TypeError(`there is no node type ${show(type)}`);
    const node = this.#make(nodeType, options);
    this.#nodes.add(node);
    if (node instanceof CollectionNode) this.#collections.add(node);
    if (node instanceof BodyNode && options.start) node.motion.start = options.start;
    for (const [name, value] of Object.entries(fields)) node.set(name, value);
    this.changed(node);
    return node;
  }

  #make(type: NodeDefinition, options: AddOptions): PhysicsNode {
    const id = options.id ?? this.nextId;
    this.nextId = Math.max(this.nextId, id + 1);
    const { host, name, version } = options;
    const collection = options.collection as PhysicsNode | undefined;
    const context = { world: this.#world, type, id, host, name, collection, version };
    if (type.make) return type.make(context);
    const early = new PhysicsNode(context);
    this.#early.add(early);
    return early;
  }

  /** Code has come: nodes that were made before become of its classes. */
  codeCame(): void {
    for (const early of this.#early) {
      const { type, id } = early as { type: NodeDefinition; id: number };
      if (!type.make) continue;
      type.make({ world: this.#world, type, id, early });
      this.#early.delete(early);
    }
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
  find(nameOrHost: unknown): PhysicsNode | undefined {
    let found: PhysicsNode | undefined;
    if (nameOrHost === undefined || nameOrHost === null) return found;
    for (const node of this.#nodes)
      if ([node.name, node.host, node.id].includes(nameOrHost)) found = node;
    return found;
  }

  /** A node was added, or fields of it changed: it is made or patched before the next step. */
  changed(node: PhysicsNode): void {
    if (node === this.defaults) return;
    this.#world.edits.add(node);
    this.#world.work();
  }

  forget(node: PhysicsNode): void {
    this.#nodes.delete(node);
    this.#early.delete(node);
    this.#collections.delete(node as CollectionNode);
    this.#world.edits.drop(node);
    this.#world.takeBack(node);
    this.#world.work();
  }

  /** Tells where later collections of a shared world say something else than the first. */
  compareCollections(): void {
    const [first] = this.#collections;
    for (const collection of this.#collections) collection.compareWith(first!);
  }
}
