import { compose, conjugate, rotate } from '../../base/math.js';
import type { Vec3 } from '../../fields/types.js';
import type { BodyNode } from '../../nodes/body.js';
import type { World } from '../../world/world.js';
import { Effect } from '../effect.js';

/** Moments that agree to this count as equal. */
const SAME = 1e-6;

/**
 * X3D's damping is a force, -factor × velocity, so mass matters. Bullet's is v·(1 - d)^dt, which is the exact
 * solution of that force for d = 1 - exp(-factor / mass). The angular one has as many rates as the body has moments:
 * where they differ, this effect damps each axis by itself.
 */
export class AxisDamping extends Effect {
  readonly name = 'axis damping';
  readonly #world: World;

  constructor(world: World) {
    super();
    this.#world = world;
  }

  update(body: BodyNode): void {
    this.drop(body);
    if (!body.asked<boolean>('autoDamp')) {
      setDamping(body, 0, 0);
      return;
    }
    const linear = 1 - Math.exp(-body.asked<number>('linearDampingFactor') / body.mass.mass);
    const factor = body.asked<number>('angularDampingFactor');
    const [x, y, z] = body.mass.moments;
    const round = Math.abs(x - y) <= SAME * x && Math.abs(x - z) <= SAME * x;
    setDamping(body, linear, round ? 1 - Math.exp(-factor / x) : 0);
    if (!round && factor > 0) this.need(body, 'angularDampingFactor on unequal moments');
  }

  override beforeStep(dt: number): void {
    for (const node of this.causes) {
      const body = node as BodyNode;
      if (body.active && !body.sleeping) this.#damp(body, dt);
    }
  }

  #damp(body: BodyNode, dt: number): void {
    const { angular } = body.velocityAtOrigin();
    const { q } = compose(body.pose(), body.centerOfMass);
    const factor = body.asked<number>('angularDampingFactor');
    const local = rotate(conjugate(q), angular).map(
      (w, i) => w * Math.exp((-factor * dt) / body.mass.moments[i]!),
    ) as Vec3;
    body.body.setAngularVelocity(this.#world.engine.scratch.vector(...rotate(q, local)));
  }
}

/** The most that single precision tells from all: nothing left would be no velocity to reckon with. */
const MOST = 1 - 2 ** -24;
const share = (value: number): number => Math.min(Math.fround(value), MOST);

/** Shares of the velocities that Bullet takes per second. */
function setDamping(body: BodyNode, linear: number, angular: number): void {
  body.dampedShare = { linear: share(linear), angular: share(angular) };
  body.body.setDamping(body.dampedShare.linear, body.dampedShare.angular);
}
