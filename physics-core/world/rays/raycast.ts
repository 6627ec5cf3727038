import { water } from '../../effects/water/effects.js';
import type { Ammo } from '../../engine/ammo.js';
import { BulletWorld, makeImmovable } from '../../engine/bullet-world.js';
import type { BtBody } from '../../engine/heap.js';
import { Owner } from '../../engine/owner.js';
import { codecs } from '../../fields/values.js';
import type { Vec3 } from '../../fields/types.js';
import { BOUNDS, shownBound } from '../../fields/bounds.js';
import { guards } from '../../base/guards.js';
import { show } from '../../base/show.js';
import {
  add,
  compose,
  invert,
  length,
  normalize,
  rotate,
  scale,
  subtract,
  type Pose,
} from '../../base/math.js';
import type { BodyNode } from '../../nodes/body/body.js';
import type { CollidableNode, NodePart } from '../../nodes/collision/collidable.js';
import type { PhysicsNode } from '../../nodes/node/node.js';
import { entryInto } from '../../shapes/ray.js';
import type { NodeWorld } from '../../nodes/node/node-world.js';

/** Every group of Bullet's, so that a ray hits whatever collides with anything or nothing. */
const EVERYTHING = -1;

/** Bullet finds convex surfaces to a centimetre (measured). */
const TOLERANCE = 0.01;

const MOST_NEAR_MISSES = 16;

/** Share of a ray on either side of a hit in which the surface surely lies. */
const STRETCH = 1e-3;

/** Rays shorter than this are cast once, metres. */
const PRECISE = 1;

/** The first thing on the way of a ray. */
export interface RayHit {
  /** The body, or the collidable where it has none; a WaterVolume where the surface of water was asked for. */
  node: PhysicsNode;
  /** Water has none. */
  collidable: CollidableNode;
  /** World frame, metres. */
  position: Vec3;
  /** Of the surface, towards where the ray came from. */
  normal: Vec3;
  /** Share of the way. */
  fraction: number;
}

type Surface = Pick<RayHit, 'position' | 'normal' | 'fraction'>;
type Hit = Surface & { pointer: number };
type Shape = Ammo['btCollisionShape']['prototype'];

/** Asks what lies on straight lines through a world. */
export class Rays {
  readonly #world: NodeWorld;
  /** Bullet's boxes around the bodies are those of the present poses. */
  #boxesHold = false;
  #probe: Probe | undefined;

  constructor(world: NodeWorld) {
    this.#world = world;
  }

  /** Something moved: Bullet itself looks at the boxes only in its next step. */
  moved(): void {
    this.#boxesHold = false;
  }

  /** `surfaces`: those of water are hit, too. */
  cast(from: unknown, to: unknown, surfaces?: boolean): RayHit | null {
    const world = this.#world;
    const [start, end] = [this.#point('from', from), this.#point('to', to)];
    if (!start || !end || !world.started) return null;
    world.flush();
    this.#updateBoxes();
    const hit = this.#seen(start, end);
    const surface = surfaces && world.registry.find(water)?.meets(start, end);
    return surface && !(surface.fraction > (hit?.fraction ?? 1)) ? (surface as never) : hit;
  }

  /** From and to Bullet's origin. */
  #seen(from: Vec3, to: Vec3): RayHit | null {
    const { origin } = this.#world.poses;
    const hit = this.#first(subtract(from, origin), subtract(to, origin));
    return hit && { ...hit, position: add(hit.position, origin) };
  }

  /** Bullet's tolerance takes near misses for hits; the ray then goes on behind them. */
  #first(from: Vec3, to: Vec3): RayHit | null {
    const total = length(subtract(to, from));
    let gone = 0;
    for (let tries = 0; tries < MOST_NEAR_MISSES && gone < 1; tries++) {
      const start = add(from, scale(subtract(to, from), gone));
      const hit = castIn(this.#world.bullet, start, to);
      const body = hit && (this.#world.bodyAt(hit.pointer) as BodyNode | undefined);
      const part = body && this.#partOf(body, start, to);
      if (!part) return null;
      const fraction = gone + (1 - gone) * hit.fraction;
      const exact = exactly(body, part, from, to);
      const surface = exact === undefined ? { ...placed(hit), fraction } : exact;
      if (surface) return { node: body.standsFor, collidable: part.collidable, ...surface };
      gone = fraction + (2 * TOLERANCE) / total;
    }
    return null;
  }

  #point(name: string, value: unknown): Vec3 | undefined {
    const point = codecs.SFVec3f.accept(value) as Vec3 | undefined;
    if (point && guards.bounded(point, BOUNDS.plain)) return point;
    this.#world.report({
      code: 'bad-value',
      severity: 'warning',
      attribute: name,
      value,
      used: 'nothing',
      message: `raycast takes two points of three finite numbers up to ${shownBound(BOUNDS.plain)}; ${name} is ${show(value)}, so nothing is hit`,
    });
    return undefined;
  }

  #updateBoxes(): void {
    if (this.#boxesHold) return;
    this.#boxesHold = true;
    const { bullet } = this.#world.bullet;
    for (const body of this.#world.bodies) if (body.active) bullet.updateSingleAabb(body.body);
  }

  /** Bullet does not say which child of a compound was hit, so each is asked alone. */
  #partOf(body: BodyNode, from: Vec3, to: Vec3): NodePart | undefined {
    const parts = body.solidParts;
    if (parts.length <= 1) return parts[0];
    const { ammo } = this.#world.engine;
    const compound = ammo.castObject(body.body.getCollisionShape(), ammo.btCompoundShape);
    this.#probe ??= new Probe(this.#world);
    let nearest: { fraction: number; part: NodePart } | undefined;
    for (const [i, part] of parts.entries()) {
      const child = compound.getChildShape(i);
      const fraction = this.#probe.cast(child, compose(body.poseInBullet(), part.pose), from, to);
      if (fraction < (nearest?.fraction ?? Infinity)) nearest = { fraction, part };
    }
    return nearest?.part;
  }

  dispose(): void {
    this.#probe?.dispose();
    this.#probe = undefined;
    this.#boxesHold = false;
  }
}

/** One shape alone in a world of its own. */
class Probe {
  readonly #world: NodeWorld;
  readonly #alone: BulletWorld;
  readonly #owner: Owner;
  readonly #body: BtBody;

  constructor(world: NodeWorld) {
    const { engine } = world;
    this.#world = world;
    this.#alone = new BulletWorld(engine);
    this.#owner = new Owner(engine.ammo);
    this.#body = makeImmovable(engine, this.#owner);
    this.#alone.addBody(this.#body, 0, EVERYTHING, EVERYTHING);
  }

  /** Share of the way to the shape; Infinity where the ray misses it. */
  cast(shape: Shape, pose: Pose, from: Vec3, to: Vec3): number {
    const { scratch } = this.#world.engine;
    this.#body.setCollisionShape(shape);
    this.#body.setWorldTransform(scratch.transform(pose.p, pose.q));
    this.#alone.bullet.updateSingleAabb(this.#body);
    return castIn(this.#alone, from, to)?.fraction ?? Infinity;
  }

  dispose(): void {
    this.#alone.removeBody(this.#body);
    this.#owner.dispose();
    this.#alone.dispose();
  }
}

/** In single precision a long ray is coarse; it is cast again in the stretch around what it hits. */
function castIn(world: BulletWorld, from: Vec3, to: Vec3): Hit | undefined {
  const way = subtract(to, from);
  const total = length(way);
  if (total === 0) return undefined;
  const at = (share: number): Vec3 => add(from, scale(way, share));
  let hit = castOnce(world, from, to);
  for (let share = STRETCH; hit && share * total > PRECISE * STRETCH; share *= 2 * STRETCH) {
    const [low, high] = [Math.max(0, hit.fraction - share), Math.min(1, hit.fraction + share)];
    const closer = castOnce(world, at(low), at(high));
    if (!closer) break;
    hit = { ...closer, fraction: low + (high - low) * closer.fraction };
  }
  return hit;
}

const placed = ({ position, normal, fraction }: Hit): Surface => ({ position, normal, fraction });

/** Boxes, spheres and cylinders have a formula. Null: the ray misses by it. */
function exactly(body: BodyNode, part: NodePart, from: Vec3, to: Vec3): Surface | null | undefined {
  const pose = compose(body.poseInBullet(), part.pose);
  const toPart = invert(pose);
  const local = (point: Vec3): Vec3 => add(toPart.p, rotate(toPart.q, point));
  const found = entryInto(part.geometry, local(from), local(to));
  return (
    found && {
      position: add(from, scale(subtract(to, from), found.share)),
      normal: normalize(rotate(pose.q, found.normal)),
      fraction: found.share,
    }
  );
}

function castOnce({ engine, bullet }: BulletWorld, from: Vec3, to: Vec3): Hit | undefined {
  const { ammo, scratch } = engine;
  const [start, end] = [scratch.vector(...from, 0), scratch.vector(...to, 1)];
  const result = new ammo.ClosestRayResultCallback(start, end);
  result.set_m_collisionFilterGroup(EVERYTHING);
  result.set_m_collisionFilterMask(EVERYTHING);
  bullet.rayTest(start, end, result);
  const hit = result.hasHit() ? read(ammo, result) : undefined;
  ammo.destroy(result);
  return hit;
}

function read(ammo: Ammo, result: Ammo['ClosestRayResultCallback']['prototype']): Hit {
  const numbers = (v: { x(): number; y(): number; z(): number }): Vec3 => [v.x(), v.y(), v.z()];
  return {
    pointer: ammo.getPointer(result.get_m_collisionObject()),
    position: numbers(result.get_m_hitPointWorld()),
    normal: numbers(result.get_m_hitNormalWorld()),
    fraction: result.get_m_closestHitFraction(),
  };
}
