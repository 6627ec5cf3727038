import { compose } from '../base/math.js';
import { POSE } from '../dynamics/poses.js';
import { VELOCITY } from '../engine/moving-bodies.js';
import type { BodyNode } from '../nodes/body/body.js';
import type { World } from '../world/world.js';
import { STATE, type Answer } from './messages.js';

/** Shows a world here where it is on another thread. */
export class Mirror {
  readonly #world: World;
  #byId = new Map<number, BodyNode>();
  /** What that was made of. */
  #reviews = -1;
  /** Whose Bullet body stands where it stood. */
  readonly #late = new Set<BodyNode>();

  constructor(world: World) {
    this.#world = world;
  }

  take({ states, count }: Answer): void {
    const { poses, bodies } = this.#world;
    const { moving } = bodies;
    this.#lookUp();
    for (let i = 0, at = 0; i < count; i++, at += STATE) {
      const body = this.#byId.get(states[at]!);
      // It was removed here meanwhile.
      if (!body || body.slot < 0) continue;
      const { slot } = body;
      moving.asleep[slot] = states[at + 1]!;
      for (let k = 0; k < POSE; k++) {
        poses.previous[slot * POSE + k] = states[at + 2 + k]!;
        poses.current[slot * POSE + k] = states[at + 2 + POSE + k]!;
      }
      for (let k = 0; k < VELOCITY; k++)
        moving.velocities[slot * VELOCITY + k] = states[at + 2 + 2 * POSE + k]!;
      poses.mark(slot);
      this.#late.add(body);
    }
  }

  #lookUp(): void {
    const { bodies } = this.#world;
    if (this.#reviews === bodies.moving.reviews) return;
    this.#reviews = bodies.moving.reviews;
    this.#byId = new Map([...bodies].map((body) => [body.id, body]));
  }

  /** Bullet's bodies stand where they are shown: before something is made, patched or looked at. */
  place(): void {
    if (this.#late.size === 0) return;
    for (const body of this.#late) if (body.built) this.#place(body);
    this.#late.clear();
    this.#world.rays.moved();
  }

  #place(node: BodyNode): void {
    const { engine, bodies } = this.#world;
    const { p, q } = compose(node.motion.poseInBullet(), node.centerOfMass);
    const [vx, vy, vz, wx, wy, wz] = bodies.velocityOf(node);
    node.body.setCenterOfMassTransform(engine.scratch.transform(p, q));
    node.body.setLinearVelocity(engine.scratch.vector(vx!, vy!, vz!));
    node.body.setAngularVelocity(engine.scratch.vector(wx!, wy!, wz!));
  }
}
