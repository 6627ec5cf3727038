import type { Body } from '../dynamics/body.js';
import { compose } from '../base/math.js';
import { grown } from '../base/grown.js';
import { writeMatrix } from '../base/matrix.js';
import { POSE } from '../dynamics/poses.js';
import { jointSolve } from '../effects/joints/effects.js';
import { particles } from '../effects/particles/effects.js';
import { deformables } from '../effects/deformables/effects.js';
import { ropes } from '../effects/soft/effects.js';
import { waves } from '../effects/water/effects.js';
import { MovingBodies, VELOCITY } from '../engine/moving-bodies.js';
import { placeBody } from '../engine/place-body.js';
import type { BodyNode } from '../nodes/body/body.js';
import type { World } from '../world/world.js';
import { SHOWN, STATE, type Answer } from './messages.js';

/** Shows a world here where it is on another thread. */
export class Mirror {
  readonly #world: World;
  /** By the number of a body. */
  #slots = new Map<number, number>();
  /** What that was made of. */
  #reviews = -1;
  /** By slot: 1 where the Bullet body stands where it stood. */
  #late = new Uint8Array(0);
  #anyLate = false;
  /** By slot, linear then angular, as they were told. */
  #told: Float64Array = new Float64Array(0);
  /** And those that are shown. */
  #velocities: Float64Array = new Float64Array(0);
  /** By slot: where it stood when it was looked at last. */
  #stood: Float64Array = new Float64Array(0);
  /** By slot: the order by which the other side hears of where it was put here. */
  #orders: Float64Array = new Float64Array(0);
  readonly #rotation = new Float64Array(9);

  constructor(world: World) {
    this.#world = world;
  }

  /** An order tells the other side where bodies were put here: what is answered to earlier ones is older than that. */
  note(order: number): void {
    const { current } = this.#world.poses;
    const slots = current.length / POSE;
    if (this.#orders.length < slots) {
      this.#stood = grown(this.#stood, current.length);
      this.#orders = grown(this.#orders, slots);
    }
    for (let slot = 0; slot < slots; slot++)
      for (let k = slot * POSE; k < (slot + 1) * POSE; k++)
        if (current[k] !== this.#stood[k]) {
          this.#stood[k] = current[k]!;
          this.#orders[slot] = order;
        }
  }

  /** `stepped`: since the last one; what moves is told anew with each step, and the rest stands. */
  take(
    { number, states, count, clouds, surfaces, ropes: hung, deformables: bent }: Answer,
    stepped: boolean,
  ): void {
    const { poses, bodies, registry } = this.#world;
    const { moving } = bodies;
    this.#lookUp();
    if (stepped) poses.shift();
    this.#told = roomIn(this.#told, moving);
    this.#velocities = roomIn(this.#velocities, moving);
    const joints = registry.find(jointSolve);
    if (joints) joints.shownOf = this.#shownOf;
    for (let i = 0, at = 0; i < count; i++, at += STATE) {
      const slot = this.#slots.get(states[at]!);
      // It was removed here meanwhile.
      if (slot === undefined || !bodies.in(slot)) continue;
      moving.asleep[slot] = states[at + 1]!;
      if (!(this.#orders[slot]! > number))
        for (let k = 0; k < POSE; k++) {
          poses.previous[slot * POSE + k] = states[at + 2 + k]!;
          poses.current[slot * POSE + k] = this.#stood[slot * POSE + k] =
            states[at + 2 + POSE + k]!;
        }
      for (let k = 0; k < VELOCITY; k++) {
        const velocity = states[at + 2 + 2 * POSE + k]!;
        moving.velocities[slot * VELOCITY + k] = this.#told[slot * VELOCITY + k] = velocity;
        this.#velocities[slot * VELOCITY + k] = states[at + SHOWN + k]!;
      }
      poses.mark(slot);
      this.#late[slot] = 1;
    }
    this.#anyLate ||= count > 0;
    registry.find(particles)?.hear(clouds);
    if (surfaces) registry.find(waves)?.hear(surfaces);
    if (hung) registry.find(ropes)?.hear(hung);
    if (bent) registry.find(deformables)?.hear(bent);
  }

  #lookUp(): void {
    const { bodies } = this.#world;
    if (this.#reviews === bodies.moving.reviews) return;
    this.#reviews = bodies.moving.reviews;
    this.#slots = new Map([...bodies].map(({ id, slot }) => [id, slot]));
    if (this.#late.length >= bodies.moving.slots) return;
    const late = new Uint8Array(bodies.moving.asleep.length);
    late.set(this.#late);
    this.#late = late;
  }

  /** Until its velocity is given anew. */
  readonly #shownOf = ({ slot }: Body): { velocities: Float64Array; at: number } | undefined => {
    const at = slot * VELOCITY;
    if (at + VELOCITY > this.#told.length) return undefined;
    const { velocities } = this.#world.bodies;
    for (let k = at; k < at + VELOCITY; k++) if (velocities[k] !== this.#told[k]) return undefined;
    return { velocities: this.#velocities, at };
  };

  /** Bullet's bodies stand where they are shown: before something is made, patched or read of Bullet. */
  place(): void {
    if (!this.#anyLate) return;
    this.#anyLate = false;
    const { bodies } = this.#world;
    for (let slot = 0; slot < this.#late.length; slot++) {
      const body = this.#late[slot] ? bodies.in(slot) : undefined;
      if (body?.built) this.#place(body);
    }
    this.#late.fill(0);
    this.#world.rays.moved();
  }

  /** On the heap alone: nothing is simulated from there. */
  #place(node: BodyNode): void {
    const { engine, bodies } = this.#world;
    const { p, q } = compose(node.motion.poseInBullet(), node.centerOfMass);
    engine.velocities.write(node.pointer, bodies.velocityOf(node), 0);
    writeMatrix(this.#rotation, 0, q, 0);
    placeBody(engine.ammo, node.pointer, p, this.#rotation);
  }

  /** It is simulated here again. */
  end(): void {
    const joints = this.#world.registry.find(jointSolve);
    if (joints) joints.shownOf = undefined;
  }
}

const roomIn = (velocities: Float64Array, { velocities: all }: MovingBodies): Float64Array =>
  velocities.length < all.length ? grown(velocities, all.length) : velocities;
