import { PhysicsNode } from '../nodes/node/node.js';
import type { LevelName } from '../dynamics/levels.js';
import type { Hold } from '../effects/drag/hold.js';
import type { Call } from '../world/recording.js';
import type { Reference } from '../world/snapshot/snapshot.js';
import type { World } from '../world/world.js';

// What is done to a world by methods, as plain data: nodes by their numbers. Functions and elements stay where they are.

const isPlain = (value: object): boolean => {
  const prototype: unknown = Object.getPrototypeOf(value);
  return prototype === Object.prototype || prototype === null;
};

/** An argument that is left out: JSON would make null of it. */
const LEFT_OUT = { leftOut: true };

const PLAIN = ['boolean', 'number', 'string'];

/** What holds itself is no data, either. */
export const encode = (value: unknown): unknown => encodeIn(value, []);

function encodeIn(value: unknown, holders: readonly object[]): unknown {
  if (value === null || PLAIN.includes(typeof value)) return value;
  if (value instanceof PhysicsNode) return { nodeId: value.id } satisfies Reference;
  if (typeof value !== 'object' || holders.includes(value)) return LEFT_OUT;
  if (ArrayBuffer.isView(value)) return Array.from(value as unknown as ArrayLike<number>);
  const within = [...holders, value];
  if (Array.isArray(value)) return value.map((one) => encodeIn(one, within));
  if (!isPlain(value)) return LEFT_OUT;
  const entries = Object.entries(value).map(([name, one]) => [name, encodeIn(one, within)]);
  return Object.fromEntries(entries);
}

/** `node`: by its number. */
export function decode(value: unknown, node: (id: number) => PhysicsNode | undefined): unknown {
  if (Array.isArray(value)) return value.map((item) => decode(item, node));
  if (typeof value !== 'object' || value === null) return value;
  if ('leftOut' in value) return undefined;
  if ('nodeId' in value) return node((value as Reference).nodeId) ?? null;
  return Object.fromEntries(Object.entries(value).map(([name, one]) => [name, decode(one, node)]));
}

/** That a method is called from outside. `drag`: the number of the drag that is meant, or begins. */
export function callOf(
  { store, stepping }: Pick<World, 'store' | 'stepping'>,
  who: object | undefined,
  drag: number | undefined,
  step: number,
  method: string,
  args: readonly unknown[],
): Call {
  return {
    step,
    ...(who instanceof PhysicsNode && { node: who.id }),
    ...(drag !== undefined && { drag }),
    method,
    args: args.map(encode),
    next: store.nextId,
    singly: stepping.singly,
  };
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

type Methods = Record<string, unknown>;

/** Does again in one world what was done in another. */
export class Redoing {
  readonly #world: World;
  #nodes = new Map<number, PhysicsNode>();
  readonly #drags = new Map<number, Hold>();

  constructor(world: World) {
    this.#world = world;
  }

  /** A drag that is under way. */
  hold(drag: number, body: number, point: number[]): void {
    this.#do({ node: body, drag, method: 'drag', args: [point] });
  }

  do(call: Call): void {
    this.#world.store.nextId = call.next;
    this.#world.stepping.singly = call.singly;
    if (call.method === 'level') this.#goTo(call.args[0] as LevelName);
    else this.#do(call);
  }

  /** Where the level is left to itself. */
  #goTo(level: LevelName): void {
    const { control } = this.#world;
    control.begin(level, control.parts);
    this.#world.configure();
  }

  #do(call: Pick<Call, 'node' | 'drag' | 'method' | 'args'>): void {
    const who = this.#whose(call) as unknown as Methods | undefined;
    const method = who?.[call.method];
    // What it was done to may be gone, as it was, or never have been.
    if (typeof method !== 'function') return;
    const args = this.decoded(call.args);
    const result: unknown = method.apply(who, args);
    if (call.method === 'drag' && result) this.#drags.set(call.drag!, result as Hold);
  }

  /** What was said of nodes by their numbers. */
  decoded(args: readonly unknown[]): unknown[] {
    return args.map((arg) => decode(arg, this.#node));
  }

  #whose({ node, drag }: Pick<Call, 'node' | 'drag'>): World | PhysicsNode | Hold | undefined {
    if (node !== undefined) return this.#node(node);
    return drag === undefined ? this.#world : this.#drags.get(drag);
  }

  /** Nodes come with calls, and children with their fields. */
  readonly #node = (id: number): PhysicsNode | undefined => {
    if (!this.#nodes.has(id))
      this.#nodes = new Map([...this.#world.nodes].map((node) => [node.id, node]));
    return this.#nodes.get(id);
  };
}
