import { deformableTags, particleTags, ropeTags, waterTags } from '../../elements/bridge/index.js';
import '../../elements/index.js';
import { allTypes } from '../../physics-core/all-types.js';
import { contacts, type FieldType, type World } from '../../physics-core/inside.js';
import { FRAME } from './checks.js';
import { ownScene, type Fact, type NodeData, type Stage } from './fact.js';
import { markup, nodesIn, typesByName, type Spelling } from './markup.js';
import { plain } from './plain.js';
import { worldOf } from '../browser/inside.js';
import type { Thread } from '../browser/threads.js';

export const kebab = (type: string): string =>
  type.replace(/(?<=[a-z])[A-Z]|^[A-Z]/g, (capital, at) => (at ? '-' : '') + capital.toLowerCase());

/** Both ways to write a physics node; all other nodes have one. */
export const tags = {
  plain: (type: string): string => type,
  hyphenated: (type: string): string => (allTypes[type] ? `x3d-${kebab(type)}` : type),
};

/** An element that x3dom has read. */
interface X3DElement extends Element {
  getFieldValue(field: string): unknown;
  setFieldValue(field: string, value: unknown): void;
}

interface Quaternion {
  x: number;
  y: number;
  z: number;
  w: number;
}

/** x3dom's values as plain ones. */
function fromX3DOM(type: FieldType, value: any): unknown {
  if (value === null || typeof value !== 'object') return value;
  if (type === 'SFRotation') return axisAngle(value as Quaternion);
  if ('x' in value) return 'z' in value ? [value.x, value.y, value.z] : [value.x, value.y];
  return Array.from(value as Iterable<unknown>, (item) => fromX3DOM('SFVec3f', item));
}

function axisAngle({ x, y, z, w }: Quaternion): number[] {
  const sine = Math.hypot(x, y, z);
  return sine < 1e-12 ? [0, 0, 1, 0] : [x / sine, y / sine, z / sine, 2 * Math.atan2(sine, w)];
}

const frame = (): Promise<unknown> => new Promise((resolve) => requestAnimationFrame(resolve));

/** Facts count steps, not milliseconds: a busy machine must not make a frame drop any. */
function timeless(run: () => void): void {
  performance.now = () => 0;
  try {
    run();
  } finally {
    // The platform's own, which the line above hid.
    delete (performance as { now?: unknown }).now;
  }
}

/** A scene in an `<x3d>` of this page. */
class PageStage implements Stage {
  readonly #x3d: Element;
  readonly #spelling: Spelling;
  readonly #worlds: World[];
  readonly #thread: Thread;

  constructor(x3d: Element, scene: NodeData[], spelling: Spelling, thread: Thread) {
    this.#x3d = x3d;
    this.#spelling = spelling;
    this.#thread = thread;
    const names = scene.filter(({ type }) => type === 'RigidBodyCollection').map(({ DEF }) => DEF!);
    this.#worlds = names.map((name) => worldOf(this.#element(name))! as unknown as World);
  }

  /** Nothing moves but by `advance`. What a fact adds later would have code fetched, and hold time still meanwhile. */
  async ready(): Promise<void> {
    for (const world of this.#worlds) world.paused = true;
    await Promise.all([contacts.load(), ...this.#worlds.map((world) => world.ready)]);
  }

  #element(def: string): X3DElement {
    const element = this.#x3d.querySelector(`[DEF="${def}"]`);
    if (!element) throw new Error(`the page has no node ${def}`);
    return element as X3DElement;
  }

  async get(def: string, name: string): Promise<unknown> {
    const element = this.#element(def);
    const type = this.#spelling.types.get(def)!;
    const field = allTypes[type]!.fields[name];
    if (!field) throw new Error(`${type} has no field ${name}`);
    if (field.type.endsWith('Node')) return plain(worldOf(element)!.node(element)!.get(name));
    if (element.localName.includes('-')) return (element as any)[name];
    return fromX3DOM(field.type, element.getFieldValue(name));
  }

  async set(def: string, name: string, value: unknown): Promise<void> {
    const element = this.#element(def);
    const nodes = nodesIn(value);
    const type = this.#spelling.types.get(def)!;
    const field = allTypes[type]?.fields[name];
    if (!field) throw new Error(`${type} has no field ${name}`);
    if (field.access === 'inputOnly') element.setFieldValue(name, this.#withElements(value));
    else if (field.type.endsWith('Node')) await this.#setNodes(element, name, nodes ?? []);
    else element.setFieldValue(name, value);
  }

  /** Contacts as page code hands them over: plain objects that name elements. */
  #withElements(value: unknown): unknown {
    if (Array.isArray(value)) return value.map((item) => this.#withElements(item));
    if (value === null || typeof value !== 'object') return value;
    if ('USE' in value) return this.#element(value.USE as string);
    const entries = Object.entries(value).filter(([key]) => key !== 'type');
    return Object.fromEntries(entries.map(([key, item]) => [key, this.#withElements(item)]));
  }

  /** In a page the children of an element are the nodes of its fields. */
  async #setNodes(element: Element, field: string, nodes: NodeData[]): Promise<void> {
    typesByName(nodes, this.#spelling.types);
    const names = new Set(nodes.map(({ USE }) => USE));
    const kept = new Set<string | undefined>();
    for (const child of [...element.children]) {
      if (child.getAttribute('containerField') !== field) continue;
      const name = child.getAttribute('DEF') ?? child.getAttribute('USE') ?? undefined;
      if (name && names.has(name)) kept.add(name);
      else child.remove();
    }
    const added = document.createElement('template');
    added.innerHTML = nodes
      .filter(({ USE }) => !USE || !kept.has(USE))
      .map((node) => markup(node, this.#spelling, field))
      .join('');
    element.append(document.importNode(added.content, true));
    // x3dom reads what is added when its observer runs.
    await frame();
  }

  async advance(seconds: number): Promise<void> {
    if (this.#thread === 'worker') return this.#ask(seconds);
    const frames = Math.round(seconds / FRAME);
    timeless(() => {
      for (const world of this.#worlds) {
        world.paused = false;
        for (let i = 0; i < frames; i++) world.frame(FRAME);
        world.paused = true;
      }
    });
  }

  /** The same steps, on the other thread. */
  async #ask(seconds: number): Promise<void> {
    for (const world of this.#worlds)
      await world.ask('step', Math.round(seconds / FRAME) * Math.round(FRAME / world.timeStep));
  }

  async close(): Promise<void> {
    this.#x3d.remove();
  }
}

/** Collections whose worlds run there. */
const on = (thread: Thread, scene: NodeData[]): NodeData[] =>
  scene.map((node) => (node.type === 'RigidBodyCollection' ? { ...node, thread } : node));

// What comes late would have worlds wait for it.
await Promise.all([deformableTags.load(), particleTags.load(), ropeTags.load(), waterTags.load()]);

/** Shows a fact's scene in this page. */
export async function openInPage(
  fact: Fact,
  tag: Spelling['tag'],
  thread: Thread = 'main',
): Promise<Stage> {
  const scene = thread === 'main' ? ownScene(fact) : on(thread, ownScene(fact));
  const spelling = { types: typesByName(scene), tag };
  const nodes = scene.map((node) => markup(node, spelling)).join('');
  document.body.innerHTML = `<x3d width="16px" height="16px"><scene>${nodes}</scene></x3d>`;
  const stage = new PageStage(document.body.firstElementChild!, scene, spelling, thread);
  await stage.ready();
  return stage;
}
