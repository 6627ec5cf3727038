import type { World } from '../world/world.js';
import { BodyNode } from './body.js';
import type { CollidableNode, CollidablePart } from './collidable.js';
import type { PhysicsNode } from './node.js';
import { rigidBody } from './rigid-body.js';
import { byName, type Field, type NodeType } from './table.js';

/** The fixed body that the world makes for a collidable that no RigidBody owns. Authors see the collidable instead. */
export class ObstacleNode extends BodyNode {
  collidable!: CollidableNode;
  #made: CollidablePart[] = [];

  override get isObstacle(): boolean {
    return true;
  }

  protected override get counted(): boolean {
    return false;
  }

  override get standsFor(): PhysicsNode {
    return this.collidable;
  }

  override get label(): string {
    return this.collidable.label;
  }

  override get collidables(): CollidableNode[] {
    return [this.collidable];
  }

  override get parts(): CollidablePart[] {
    return this.collidable.partsInside();
  }

  protected override create(): boolean {
    this.start = this.collidable.place;
    this.#made = this.parts;
    return super.create();
  }

  /** The collidable belongs to a body now, or nobody lists it. */
  discard(): void {
    this.removed = true;
    this.unmake();
    this.world.takeBack(this);
  }

  /** The collidable moved, or has another shape. */
  updateGeometry(): void {
    if (!this.built || this.fresh) return;
    const parts = this.parts;
    if (!sameParts(parts, this.#made)) {
      this.#made = parts;
      this.updateShape();
      this.world.pairs.refreshBody(this);
    }
    this.carryTo(this.collidable.place);
  }
}

const sameParts = (a: CollidablePart[], b: CollidablePart[]): boolean =>
  a.length === b.length &&
  a.every(
    ({ geometry, pose }, i) =>
      geometry === b[i]!.geometry &&
      [...pose.p, ...pose.q].every((value, k) => value === [...b[i]!.pose.p, ...b[i]!.pose.q][k]),
  );

const geometry: Field<ObstacleNode> = {
  ...(rigidBody.fields['geometry'] as Field),
  patch: (obstacle: ObstacleNode) => obstacle.updateGeometry(),
} as Field<ObstacleNode>;

const obstacle = {
  ...rigidBody,
  fields: byName({ ...rigidBody.fields, geometry } as Record<string, Field>),
} as unknown as NodeType;

/** It is no node of the world's: neither listed nor counted. */
export function makeObstacle(world: World, id: number, collidable: CollidableNode): ObstacleNode {
  const { host, name, collection } = collidable;
  const node = new ObstacleNode({ world, type: obstacle, id, host, name, collection });
  node.collidable = collidable;
  node.set('fixed', true);
  return node;
}
