import type { Pose } from '../../base/math.js';
import type { CollidableNode, NodePart } from '../collision/collidable.js';
import type { NodeWorld } from '../node/node-world.js';
import { BodyNode } from './body.js';
import type { BodyGeometry } from './body-geometry.js';
import { rigidBody } from './rigid-body.js';

/** One collidable that no RigidBody owns, on a fixed body that the world makes for it. Authors see the collidable. */
class ObstacleGeometry implements BodyGeometry {
  readonly isObstacle = true;
  readonly standsFor: CollidableNode;
  readonly #body: BodyNode;
  #made: readonly NodePart[] = [];

  constructor(body: BodyNode, collidable: CollidableNode) {
    this.#body = body;
    this.standsFor = collidable;
  }

  get collidables(): readonly CollidableNode[] {
    return [this.standsFor];
  }

  get parts(): NodePart[] {
    return this.standsFor.partsInside();
  }

  begin(): Pose {
    this.#made = this.parts;
    return this.standsFor.place;
  }

  /** The collidable moved, or has another shape. */
  update(): void {
    const body = this.#body;
    if (!body.built || body.fresh) return;
    const { parts } = this;
    if (!sameParts(parts, this.#made)) {
      this.#made = parts;
      body.build.updateShape();
      body.world.pairs.refreshBody(body);
    }
    body.carryTo(this.standsFor.place);
  }

  release(): void {}
}

const sameParts = (a: readonly NodePart[], b: readonly NodePart[]): boolean =>
  a.length === b.length &&
  a.every(
    ({ geometry, pose }, i) =>
      geometry === b[i]!.geometry &&
      [...pose.p, ...pose.q].every((value, k) => value === [...b[i]!.pose.p, ...b[i]!.pose.q][k]),
  );

/** It is no node of the world's: neither listed nor counted. */
export function makeObstacle(world: NodeWorld, collidable: CollidableNode): BodyNode {
  const { id, host, name, collection } = collidable;
  const node = new BodyNode(
    { world, type: rigidBody, id, host, name, collection },
    (body) => new ObstacleGeometry(body, collidable),
  );
  node.set('fixed', true);
  return node;
}

/** The collidable belongs to a body now, or nobody lists it. */
export function discardObstacle(obstacle: BodyNode): void {
  obstacle.removed = true;
  obstacle.unmake();
  obstacle.world.takeBack(obstacle);
}
