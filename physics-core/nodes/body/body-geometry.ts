import type { Pose } from '../../base/math.js';
import type { CollidableNode, NodePart } from '../collision/collidable.js';
import type { PhysicsNode } from '../node/node.js';
import type { BodyNode } from './body.js';

/** What the shape of a body is made of, and whom authors know it by. */
export interface BodyGeometry {
  /** Whether the world made the body for a collidable without one. */
  readonly isObstacle: boolean;
  /** The node that authors know it by; undefined: the body itself. */
  readonly standsFor?: PhysicsNode;
  readonly collidables: readonly CollidableNode[];
  /** The parts that collide, in the body's frame. */
  readonly parts: NodePart[];
  /** The body is about to be made. Where it starts if its author says nothing; `start`: where others say it does. */
  begin(start: Pose | undefined): Pose | undefined;
  /** The collidables, or what they are made of, have changed. */
  update(): void;
  /** The body is gone. */
  release(): void;
}

/** Collidables that a RigidBody names: it owns them. */
export class OwnedGeometry implements BodyGeometry {
  readonly isObstacle = false;
  readonly #body: BodyNode;
  #named: readonly CollidableNode[] = [];

  constructor(body: BodyNode) {
    this.#body = body;
  }

  get collidables(): readonly CollidableNode[] {
    return this.#body.asked<CollidableNode[]>('geometry');
  }

  get parts(): NodePart[] {
    return this.collidables.flatMap((collidable) =>
      collidable.owner === this.#body && !collidable.removed ? collidable.parts() : [],
    );
  }

  begin(start: Pose | undefined): Pose | undefined {
    this.#claim();
    return start ?? this.collidables.find((collidable) => collidable.startPose)?.startPose;
  }

  update(): void {
    this.#claim();
    if (this.#body.built) this.#body.build.updateShape();
    this.#body.world.pairs.refreshBody(this.#body);
  }

  /** What it no longer names is free for the next. */
  #claim(): void {
    const named = this.collidables;
    for (const old of this.#named) if (!named.includes(old)) old.releaseFrom(this.#body);
    this.#named = [...named];
    for (const collidable of named) collidable.claim(this.#body);
  }

  release(): void {
    for (const collidable of this.collidables) collidable.releaseFrom(this.#body);
  }
}
