import type { Vec3 } from '../../fields/types.js';
import type { Body } from '../../dynamics/body.js';
import type { SimulationNode } from '../../dynamics/node.js';

/** A resting sphere has a distance of 1.5e-16 in some steps: bodies touch from the first on, until the second, metres. */
export const BEGIN = 0.001;
const END = 0.01;

export type CollisionEnd = 'separated' | 'removed' | 'disabled' | 'reset';

/** Where two bodies touch. World frame; the normal points into the body whose event it is. */
export interface TouchPoint {
  position: Vec3;
  normal: Vec3;
  /** Metres, negative is a gap. */
  depth: number;
  /** N s. */
  impulse: number;
}

/** Detail of `collisionstart` and `collisionend`. */
export interface Collision {
  /** The other body, or the collidable without one. */
  other: SimulationNode;
  /** N s passed on between them from the first push of the hit on; 0 at the end. */
  impulse: number;
  contacts: TouchPoint[];
  time: number;
  reason?: CollisionEnd;
}

/** Passes for which Bullet may lose sight of balls a hair apart. */
const UNSEEN = 1;

/** Two bodies near each other. */
interface Touch {
  a: Body;
  b: Body;
  /** The pass that last saw them. */
  pass: number;
  nearest: number;
  impulse: number;
  begun: boolean;
}

/** Node ids of a pair in one number. */
export const keyOf = (a: Body, b: Body): number =>
  a.id < b.id ? a.id * 2 ** 26 + b.id : b.id * 2 ** 26 + a.id;

/** What touches what, from step to step: one beginning and one end for each touch. */
export class Touches {
  readonly #touches = new Map<number, Touch>();
  #pass = 0;
  readonly #pointsOf: (touch: { a: Body; b: Body }, into: Body) => TouchPoint[];

  constructor(pointsOf: (touch: { a: Body; b: Body }, into: Body) => TouchPoint[]) {
    this.#pointsOf = pointsOf;
  }

  /** A new pass over what is near. */
  begin(): void {
    this.#pass++;
  }

  /** One contact point of the pass. */
  note(a: Body, b: Body, distance: number, impulse: number): void {
    const key = keyOf(a, b);
    let touch = this.#touches.get(key);
    if (!touch) {
      touch = { a, b, pass: 0, nearest: Infinity, impulse: 0, begun: false };
      this.#touches.set(key, touch);
    }
    if (touch.pass !== this.#pass) {
      touch.pass = this.#pass;
      touch.nearest = Infinity;
    }
    touch.nearest = Math.min(touch.nearest, distance);
    touch.impulse += impulse;
  }

  /** The pass is over: tells what began and what ended in it. */
  finish(time: number): void {
    for (const [key, touch] of this.#touches) {
      const gone = touch.pass < this.#pass - UNSEEN;
      const over = gone || (touch.begun && touch.nearest > END);
      if (over) this.#touches.delete(key);
      if (over && touch.begun) this.#end(touch, 'separated', time);
      if (!over && !touch.begun && touch.nearest <= BEGIN) this.#start(touch, time);
    }
  }

  touching(node: SimulationNode): boolean {
    for (const { a, b, begun } of this.#touches.values())
      if (begun && (a.standsFor === node || b.standsFor === node)) return true;
    return false;
  }

  /** A body is gone from the world: what it touched ends now. */
  part(body: Body, reason: CollisionEnd, time: number): void {
    for (const [key, touch] of this.#touches) {
      if (touch.a !== body && touch.b !== body) continue;
      this.#touches.delete(key);
      if (touch.begun) this.#end(touch, reason, time);
    }
  }

  /** Nobody listens any more. */
  forget(): void {
    this.#touches.clear();
  }

  endAll(reason: CollisionEnd, time: number): void {
    for (const touch of this.#touches.values()) if (touch.begun) this.#end(touch, reason, time);
    this.#touches.clear();
  }

  #start(touch: Touch, time: number): void {
    touch.begun = true;
    const { impulse } = touch;
    eachSide(touch, (body, node, other) => {
      const contacts = node.heard('collisionstart') ? this.#pointsOf(touch, body) : [];
      node.emit('collisionstart', { other, impulse, contacts, time } satisfies Collision);
    });
  }

  #end(touch: Touch, reason: CollisionEnd, time: number): void {
    eachSide(touch, (_, node, other) => {
      const detail: Collision = { other, impulse: 0, contacts: [], time, reason };
      node.emit('collisionend', detail);
    });
  }
}

/** Both are told, each of the other. */
function eachSide(
  { a, b }: Touch,
  tell: (body: Body, node: SimulationNode, other: SimulationNode) => void,
): void {
  tell(a, a.standsFor, b.standsFor);
  tell(b, b.standsFor, a.standsFor);
}
