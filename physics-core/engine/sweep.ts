import type { Ammo } from './ammo.js';
import type { Engine } from './engine.js';
import type { BtBody } from './heap.js';
import type { Scratch } from './scratch.js';

type Numbers = ArrayLike<number>;
type DynamicsWorld = Ammo['btDiscreteDynamicsWorld']['prototype'];

/** Group of what no sweep sees. */
const UNSEEN = 0;

const UPRIGHT = [0, 0, 0, 1];

/** Sends a ball along a straight line through a world, ahead of a body. What it meets first stands here until it is sent again. */
export class Sweep {
  readonly #ammo: Ammo;
  readonly #scratch: Scratch;
  readonly #ball: Ammo['btSphereShape']['prototype'];
  readonly #callback: Ammo['ClosestConvexResultCallback']['prototype'];
  /** Pointer of the body it met. */
  met = 0;
  /** World frame: where it touched, and the normal towards the ball. */
  readonly position = new Float64Array(3);
  readonly normal = new Float64Array(3);

  constructor(ammo: Ammo, scratch: Scratch) {
    this.#ammo = ammo;
    this.#scratch = scratch;
    this.#ball = new ammo.btSphereShape(1);
    const nothing = scratch.vector(0, 0, 0);
    this.#callback = new ammo.ClosestConvexResultCallback(nothing, nothing);
  }

  /** Whether it meets anything that the body would collide with. */
  send(world: DynamicsWorld, body: BtBody, radius: number, from: Numbers, to: Numbers): boolean {
    const scratch = this.#scratch;
    const callback = this.#callback;
    const proxy = body.getBroadphaseProxy();
    const group = proxy.get_m_collisionFilterGroup();
    this.#ball.setLocalScaling(scratch.vector(radius, radius, radius));
    callback.set_m_closestHitFraction(1);
    callback.set_m_collisionFilterGroup(group);
    callback.set_m_collisionFilterMask(proxy.get_m_collisionFilterMask());
    const start = scratch.transform(from, UPRIGHT, 0);
    const end = scratch.transform(to, UPRIGHT, 1);
    proxy.set_m_collisionFilterGroup(UNSEEN);
    world.convexSweepTest(this.#ball, start, end, callback, 0);
    proxy.set_m_collisionFilterGroup(group);
    if (callback.get_m_closestHitFraction() >= 1) return false;
    this.#read();
    return true;
  }

  #read(): void {
    const callback = this.#callback;
    this.met = this.#ammo.getPointer(callback.get_m_hitCollisionObject());
    const position = callback.get_m_hitPointWorld();
    const normal = callback.get_m_hitNormalWorld();
    this.position.set([position.x(), position.y(), position.z()]);
    this.normal.set([normal.x(), normal.y(), normal.z()]);
  }
}

/** The one of an engine. */
export const sweepOf = (engine: Engine): Sweep =>
  (engine.sweep ??= new Sweep(engine.ammo, engine.scratch));
