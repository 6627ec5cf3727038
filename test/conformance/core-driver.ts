import { allTypes } from '../../physics-core/all-types.js';
import { createWorld } from '../../physics-core/create.js';
import { PhysicsNode, type Problem, type World } from '../../physics-core/inside.js';
import { systemCode } from '../../physics-core/particles.js';
import { deformableCode } from '../../physics-core/deformables.js';
import { ropeCode } from '../../physics-core/ropes.js';
import { waterCode } from '../../physics-core/water.js';
import { FRAME } from './checks.js';
import { ownScene, type Fact, type NodeData, type Stage } from './fact.js';
import { judge, objections } from './judge.js';
import { nodesIn } from './markup.js';
import { plain } from './plain.js';

// Types of their nodes are known with them.
await Promise.all([deformableCode.load(), systemCode.load(), ropeCode.load(), waterCode.load()]);

/** Beside what a fact says itself; the accuracy level is the default one, `standard`. */
const SETTINGS = { rest: 'never' };

/** Fields of a RigidBodyCollection whose nodes know themselves where they belong. */
const MEMBERS = new Set(['bodies', 'joints']);

/** A scene in the core: each RigidBodyCollection is a world, and shows its frames as a page does. */
class CoreStage implements Stage {
  readonly worlds: World[] = [];
  /** Codes of the problems that authors were told. */
  readonly told: string[] = [];
  readonly #named = new Map<string, PhysicsNode>();
  /** Node fields wait until every DEF is known. */
  #waiting: (() => void)[] = [];

  async build(scene: NodeData[]): Promise<void> {
    const collections = scene.filter(({ type }) => type === 'RigidBodyCollection');
    for (const data of collections) await this.#collection(data);
    for (const data of scene.filter((each) => !collections.includes(each)))
      if (allTypes[data.type!]) this.#add(this.#worldOf(data), data);
    this.#connect();
  }

  /** The world is its collection. */
  async #collection(data: NodeData): Promise<void> {
    const world = await createWorld(SETTINGS);
    this.worlds.push(world);
    world.on('problem', (problem) => this.told.push((problem as Problem).code));
    const { settings } = world;
    settings.name = data.DEF;
    this.#fill(settings, data);
  }

  /** A node outside every collection belongs to the world of what it names. */
  #worldOf(data: NodeData): World {
    const names = new Set(JSON.stringify(data).match(/(?<="USE":")[^"]*/g));
    const named = [...this.#named].find(([name]) => names.has(name));
    return (named?.[1].world as World | undefined) ?? this.worlds[0]!;
  }

  #add(world: World, data: NodeData): PhysicsNode {
    const collection = world.settings;
    return this.#fill(world.add(data.type!, {}, { name: data.DEF, collection }), data);
  }

  #fill(node: PhysicsNode, { type: _, DEF, USE: __, ...fields }: NodeData): PhysicsNode {
    if (DEF) this.#named.set(DEF, node);
    for (const [field, value] of Object.entries(fields)) {
      if (!nodesIn(value)) node.set(field, value);
      else if (node.type.fields[field]) this.#hold(node, field, value);
    }
    return node;
  }

  /** Nodes in a field: those that are no USE are made now, in document order. */
  #hold(node: PhysicsNode, field: string, value: unknown): void {
    const found = nodesIn(value)!.map((data) => this.#made(node.world as World, data));
    this.#waiting.push(() => {
      const held = found.map((find) => find());
      if (!MEMBERS.has(field)) node.set(field, fitting(node, field, held));
    });
  }

  /** How to find what the data stands for, once all is made. */
  #made(world: World, data: NodeData): () => unknown {
    if (data.USE) return () => this.#node(data.USE!);
    if (data.type === 'Shape') return () => data.geometry;
    if (!allTypes[data.type!]) return () => data;
    const made = this.#add(world, data);
    return () => made;
  }

  #connect(): void {
    for (const connect of this.#waiting.splice(0)) connect();
  }

  #node(name: string): PhysicsNode {
    const node = this.#named.get(name);
    if (!node) throw new Error(`the scene has no node ${name}`);
    return node;
  }

  async get(def: string, field: string): Promise<unknown> {
    const node = this.#node(def);
    if (!node.type.fields[field]) throw new Error(`${node.type.name} has no field ${field}`);
    return plain(node.get(field));
  }

  async set(def: string, field: string, value: unknown): Promise<void> {
    const node = this.#node(def);
    if (!nodesIn(value)) {
      node.event(field, value);
      return;
    }
    const found = nodesIn(value)!.map((data) => this.#made(node.world as World, data));
    this.#connect();
    const held = found.map((find) => find());
    node.event(field, fitting(node, field, held));
  }

  async advance(seconds: number): Promise<void> {
    const frames = Math.round(seconds / FRAME);
    for (const world of this.worlds) for (let i = 0; i < frames; i++) world.frame(FRAME);
  }

  async close(): Promise<void> {
    for (const world of this.worlds) world.destroy();
  }
}

/** The core takes several Shapes where X3D takes one. */
const fitting = (node: PhysicsNode, field: string, held: unknown[]): unknown =>
  node.type.fields[field]?.type === 'SFNode' ? held[0] : held;

export async function openInCore(fact: Fact): Promise<CoreStage> {
  const stage = new CoreStage();
  await stage.build(ownScene(fact));
  return stage;
}

/** What is wrong with a fact in the core; nothing, if all is well. */
export async function wrongInCore(fact: Fact): Promise<string[]> {
  const stage = await openInCore(fact);
  try {
    const wrong = objections(await judge(fact, stage));
    const [told, expected] = [stage.told, fact.tells ?? []].map((codes) =>
      [...codes].sort().join(),
    );
    return told === expected ? wrong : [...wrong, `it tells "${told}", not "${expected}"`];
  } finally {
    await stage.close();
  }
}
