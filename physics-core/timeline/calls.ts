import { PhysicsNode } from '../nodes/node/node.js';
import type { LevelName } from '../dynamics/levels.js';
import type { Drag } from '../effects/drag/drag.js';
import type { Call } from '../world/recording.js';
import type { World } from '../world/world.js';

// What is done to a world by methods, as plain data: nodes by their numbers. Functions and elements stay where they are.

interface Reference {
  nodeId: number;
}

const isPlain = (value: object): boolean => {
  const prototype: unknown = Object.getPrototypeOf(value);
  return prototype === Object.prototype || prototype === null;
};

/** An argument that is left out: JSON would make null of it. */
const LEFT_OUT = { leftOut: true };

export function encode(value: unknown): unknown {
  if (value instanceof PhysicsNode) return { nodeId: value.id } satisfies Reference;
  if (value === undefined || typeof value === 'function') return LEFT_OUT;
  if (typeof value !== 'object' || value === null) return value;
  if (Array.isArray(value)) return value.map(encode);
  if (ArrayBuffer.isView(value)) return Array.from(value as unknown as ArrayLike<number>);
  if (!isPlain(value)) return LEFT_OUT;
  return Object.fromEntries(Object.entries(value).map(([name, one]) => [name, encode(one)]));
}

export function decode(value: unknown, nodes: ReadonlyMap<number, PhysicsNode>): unknown {
  if (Array.isArray(value)) return value.map((item) => decode(item, nodes));
  if (typeof value !== 'object' || value === null) return value;
  if ('leftOut' in value) return undefined;
  if ('nodeId' in value) return nodes.get((value as Reference).nodeId) ?? null;
  return Object.fromEntries(Object.entries(value).map(([name, one]) => [name, decode(one, nodes)]));
}

/** Methods that a recorded run may call; one from outside can't have others called. */
const METHODS = {
  world: ['add', 'flush', 'level'],
  node: [
    ...['set', 'event', 'unset', 'remove', 'belongTo', 'teleport', 'wake', 'sleep', 'drag'],
    ...['applyForce', 'applyTorque', 'applyImpulse'],
  ],
  drag: ['move', 'end', 'cancel'],
};

const kindOf = ({ node, drag }: Call): keyof typeof METHODS => {
  if (drag !== undefined && node === undefined) return 'drag';
  return node === undefined ? 'world' : 'node';
};

export const isCall = (call: Call): boolean =>
  Number.isInteger(call.step) &&
  Number.isInteger(call.next) &&
  Array.isArray(call.args) &&
  METHODS[kindOf(call)].includes(call.method);

/** Does again in one world what was done in another. */
export class Redoing {
  readonly #world: World;
  readonly #nodes: Map<number, PhysicsNode>;
  readonly #drags = new Map<number, Drag>();

  constructor(world: World) {
    this.#world = world;
    this.#nodes = new Map([...world.nodes].map((node) => [node.id, node]));
  }

  /** A drag that is under way. */
  hold(drag: number, body: number, point: number[]): void {
    this.#do({ node: body, drag, method: 'drag', args: [point] });
  }

  do(call: Call): void {
    this.#world.store.nextId = call.next;
    this.#world.stepping.singly = call.singly;
    this.#do(call);
  }

  /** Where the level is left to itself. */
  #goTo(level: LevelName): void {
    const { control } = this.#world;
    control.begin(level, control.parts);
    this.#world.configure();
  }

  #do({ node, drag, method, args }: Pick<Call, 'node' | 'drag' | 'method' | 'args'>): void {
    if (method === 'level') return this.#goTo(args[0] as LevelName);
    const given = decode(args, this.#nodes) as unknown[];
    const who =
      node === undefined ? (this.#drags.get(drag!) ?? this.#world) : this.#nodes.get(node);
    // What it was done to may be gone, or the world itself may be: of a drag nobody knows.
    if (!who || (node === undefined && drag !== undefined && who === this.#world)) return;
    const result = (who as unknown as Record<string, (...args: unknown[]) => unknown>)[method]!(
      ...given,
    );
    if (method === 'drag' && result) this.#drags.set(drag!, result as Drag);
    if (method === 'add') for (const one of this.#world.nodes) this.#nodes.set(one.id, one);
  }
}
