import { hypot } from '../../base/exact/index.js';
import { DEFAULT_FRICTION } from '../../dynamics/contact-parameters.js';
import type { NodePart } from '../collision/collidable.js';
import { reachOf, thicknessOf } from '../../effects/contacts/part-box.js';
import { wakeTouching } from '../../effects/rest/touching.js';
import { setMobility } from '../../engine/body-state.js';
import type { BtBody } from '../../engine/heap.js';
import { Owner } from '../../engine/owner.js';
import type { Vec3 } from '../../fields/types.js';
import type { BtShape } from '../../shapes/build.js';
import type { BodyNode } from './body.js';
import { shapeOf } from './body-shape.js';

const NONE: Vec3 = [0, 0, 0];

/** The btRigidBody of a body, its shape, and whether both stand in Bullet's world. */
export class BodyObject {
  readonly #node: BodyNode;
  #owner: Owner | undefined;
  #shapeOwner: Owner | undefined;
  #groups: readonly [number, number] = [0, 0];
  inWorld = false;
  body!: BtBody;
  /** On the heap. */
  pointer = 0;
  /** Those of its parts that have a shape in Bullet, in Bullet's order. */
  solidParts: NodePart[] = [];
  /** Their least extent, metres, once it was asked for. */
  #leastExtent: number | undefined;
  #reach: number | undefined;

  constructor(node: BodyNode) {
    this.#node = node;
  }

  make(): void {
    const { world, mass, movable } = this.#node;
    const { ammo, scratch } = world.engine;
    this.#owner = new Owner(ammo);
    this.#shapeOwner = new Owner(ammo);
    const shape = this.#makeShape();
    // Bullet takes an inertia at mass 0 too, and would let joints and contacts turn the immovable body.
    const inertia = scratch.vector(...(movable ? mass.moments : NONE));
    const info = new ammo.btRigidBodyConstructionInfo(
      movable ? mass.mass : 0,
      null as never,
      shape,
      inertia,
    );
    try {
      this.body = this.#owner.own(new ammo.btRigidBody(info));
    } finally {
      ammo.destroy(info);
    }
    // Bullet multiplies the frictions of both bodies.
    this.body.setFriction(Math.sqrt(DEFAULT_FRICTION));
    this.pointer = ammo.getPointer(this.body);
  }

  dispose(): void {
    this.#owner?.dispose();
    this.#shapeOwner?.dispose();
  }

  #makeShape(): BtShape {
    const { shape, parts } = shapeOf(this.#node, this.#shapeOwner!);
    this.solidParts = parts;
    this.#leastExtent = this.#reach = undefined;
    return shape;
  }

  /** Another shape for the same btRigidBody, which is out of the world meanwhile. */
  replaceShape(): void {
    const old = this.#shapeOwner;
    this.#shapeOwner = new Owner(this.#node.world.engine.ammo);
    try {
      this.body.setCollisionShape(this.#makeShape());
    } finally {
      old?.dispose();
    }
  }

  /** Mass and moments, none where it does not move. */
  setMass(): void {
    const { world, mass, movable } = this.#node;
    const { scratch } = world.engine;
    const moments = scratch.vector(...(movable ? mass.moments : NONE));
    this.body.setMassProps(movable ? mass.mass : 0, moments);
    this.setFlags();
    if (!movable) this.#node.setVelocityAtOrigin({ linear: [0, 0, 0], angular: [0, 0, 0] });
    this.body.updateInertiaTensor();
  }

  setFlags(): void {
    const { movable, kinematic } = this.#node;
    setMobility(this.body, movable ? 'dynamic' : kinematic ? 'kinematic' : 'static');
  }

  /** Whether it stands in the world in just these collision groups. */
  isIn([group, mask]: readonly [number, number]): boolean {
    return this.inWorld && group === this.#groups[0] && mask === this.#groups[1];
  }

  enter(groups: readonly [number, number]): void {
    this.leave();
    this.#groups = groups;
    this.setFlags();
    this.#node.world.bullet.addBody(this.body, this.#node.id, ...groups);
    this.inWorld = true;
    this.#node.world.bodies.review(this.#node);
  }

  leave(): void {
    if (!this.inWorld) return;
    const { world } = this.#node;
    wakeTouching(world, world.registry, this.#node);
    world.bullet.removeBody(this.body);
    this.inWorld = false;
    world.bodies.review(this.#node);
  }

  /** Lets go of what it touches: Bullet keeps the contacts of a pair that is no longer to be tested. */
  partContacts(): void {
    const { bullet } = this.#node.world;
    bullet.removeBody(this.body);
    bullet.addBody(this.body, this.#node.id, ...this.#groups);
  }

  /** Asked for in every step: looked up once for a shape. */
  get leastExtent(): number {
    return (this.#leastExtent ??= thicknessOf(this.#node));
  }

  get reach(): number {
    return (this.#reach ??= reachOf(this.#node));
  }

  /** Half the diagonal of the box around it, metres. */
  get size(): number {
    const { scratch } = this.#node.world.engine;
    const [low, high] = [scratch.vector(0, 0, 0, 0), scratch.vector(0, 0, 0, 1)];
    this.body.getAabb(low, high);
    return hypot(high.x() - low.x(), high.y() - low.y(), high.z() - low.z()) / 2;
  }
}
