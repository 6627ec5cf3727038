import type { Joint } from '../../dynamics/joint.js';
import { dot3 } from '../../base/flat-math.js';
import { Gimbal } from './gimbal.js';
import { SIDE } from '../../solver/joints/blocks.js';
import type { JointEnds } from './joint-ends.js';
import type { End } from './joint-geometry.js';
import type { JointedBodies } from './jointed-bodies.js';
import type { RowSystem } from '../../solver/joints/row-system.js';

/**
 * Tells Bullet's own constraints what was found: each locked row is asked to be, after the step, where the velocities
 * found take it. Its solver then has nothing to do about joints until a contact interferes, and in that case keeps the
 * joints to what was found instead of to where they stand now.
 */
export class BulletTargets {
  readonly #system: RowSystem;
  readonly #bodies: JointedBodies;
  readonly #ends: JointEnds;
  /** Of body 1 against body 2: the speed at the joint, and the spin. */
  readonly #speed = new Float64Array(3);
  readonly #spin = new Float64Array(3);
  readonly #axis = new Float64Array(3);
  /** Of A against B. */
  readonly #gimbal = new Gimbal();

  constructor(system: RowSystem, bodies: JointedBodies, ends: JointEnds) {
    this.#system = system;
    this.#bodies = bodies;
    this.#ends = ends;
  }

  tell(k: number, joint: Joint, dt: number): void {
    const { place, turn } = this.#bodies;
    const { constraint } = joint;
    const { one, two } = this.#ends.geometry;
    this.#ends.read(k, place, turn);
    this.#readMotion(k, constraint!.atOnePoint ? two : one, dt);
    const swapped = constraint!.swapped;
    const a = swapped ? two : one;
    const b = swapped ? one : two;
    const sign = swapped ? -1 : 1;
    this.#gimbal.look(a.axes, b.axes);
    for (const row of joint.lockedRows) {
      const { erp } = joint.corrections[row]!;
      if (erp === 0) continue;
      const per = (sign * dt) / erp;
      if (row < 3) {
        const at = row * 3;
        let apart = 0;
        for (let x = 0; x < 3; x++) apart += a.axes[at + x]! * (b.origin[x]! - a.origin[x]!);
        constraint!.setTarget(row, apart - per * dot3(a.axes, at, this.#speed, 0));
      } else {
        this.#gimbal.writeAxis(row, this.#axis, 0);
        const turning = per * dot3(this.#axis, 0, this.#spin, 0);
        constraint!.setTarget(row, this.#gimbal.angle(row) + turning);
      }
    }
  }

  #readMotion(k: number, { origin }: End, dt: number): void {
    const { a, b } = this.#ends.edges[k]!;
    this.#speed.fill(0);
    this.#spin.fill(0);
    this.#addMotion(a, origin, 1);
    this.#addMotion(b, this.#ends.geometry.two.origin, -1);
    if (!this.#ends.moves(k)) return;
    const { one, two } = this.#ends.geometry;
    if (a < 0) this.#add(this.#ends.rates(k, 0, dt), 0, one.origin, 0, origin, 1);
    if (b < 0) this.#add(this.#ends.rates(k, 1, dt), 0, two.origin, 0, two.origin, -1);
  }

  #addMotion(body: number, point: Float64Array, sign: 1 | -1): void {
    if (body < 0) return;
    this.#add(this.#system.velocity, body * SIDE, this.#bodies.place, body * 3, point, sign);
  }

  /** A velocity, of what is at `place[p]`, at a point. */
  #add(
    velocity: Float64Array,
    v: number,
    place: Float64Array,
    p: number,
    point: Float64Array,
    sign: 1 | -1,
  ): void {
    const wx = velocity[v + 3]!;
    const wy = velocity[v + 4]!;
    const wz = velocity[v + 5]!;
    const x = point[0]! - place[p]!;
    const y = point[1]! - place[p + 1]!;
    const z = point[2]! - place[p + 2]!;
    this.#speed[0]! += sign * (velocity[v]! + wy * z - wz * y);
    this.#speed[1]! += sign * (velocity[v + 1]! + wz * x - wx * z);
    this.#speed[2]! += sign * (velocity[v + 2]! + wx * y - wy * x);
    for (let i = 0; i < 3; i++) this.#spin[i]! += sign * velocity[v + 3 + i]!;
  }
}
