import { ContactPoint } from '../../engine/contact-point.js';
import type { Engine } from '../../engine/engine.js';
import { BODY } from '../../engine/offsets.js';
import type { BodyNode } from '../../nodes/body.js';
import type { World } from '../../world/world.js';
import { EffectiveMassMatrix } from './effective-mass-matrix.js';
import { hangsOnMoving, isJointed } from '../../dynamics/jointed.js';
import { multiply4, writeTurn } from '../../base/flat-math.js';

/** Below this approach a hit is over: what bounces less and less would go on for ever, m/s. */
export const OVER = 1e-3;

/** Linear, then angular. */
const WIDTH = 6;

const pose = new Float64Array(7);
const velocity = new Float64Array(6);
const displacement = new Float64Array(3);
const turn = new Float64Array(4);

/** A body that is hit, and where. */
export class StruckBody {
  readonly effectiveMass = new EffectiveMassMatrix();
  readonly hits: Impact[] = [];
  body!: BodyNode;
  movable = false;
  /** Whether the joint solve moves it, and whether others that move hang on it. */
  jointed = false;
  hangs = false;
  /** The step that it belongs to. */
  step = -1;
  /** Whether its effectiveMass is known in this step, and it was struck. */
  #known = false;
  struck = false;
  /** The step that it was last struck in. */
  struckIn = -1;
  /** Velocity before it was struck. */
  readonly before = new Float64Array(WIDTH);
  /** When Bullet's solver lets it bounce, seconds; NaN: it does not. */
  bounces = NaN;
  /** What hits changed of its velocity, and how far that is not yet on its way at the start of the step. */
  readonly change = new Float64Array(WIDTH);
  readonly late = new Float64Array(WIDTH);

  take(body: BodyNode, step: number): void {
    this.step = step;
    this.body = body;
    this.movable = body.movable;
    this.jointed = isJointed(body);
    this.hangs = hangsOnMoving(body);
    this.hits.length = 0;
    this.#known = this.struck = false;
    this.bounces = NaN;
  }

  /** What a push would do to it now. */
  known(world: World): EffectiveMassMatrix {
    if (!this.#known) this.effectiveMass.read(this.body, world);
    this.#known = true;
    return this.effectiveMass;
  }

  /** Applies an impulse of `effectiveMass` at a time of the step. */
  push(heap: Float32Array, impulse: number, time: number): void {
    if (!this.struck) this.#begin(heap);
    this.effectiveMass.push(heap, impulse);
    for (let i = 0; i < WIDTH; i++) {
      const change = impulse * this.effectiveMass.change[i]!;
      this.change[i]! += change;
      this.late[i]! -= time * change;
    }
  }

  /** Bullet's solver will let it bounce, in several points together; the first of them tells the time. */
  bounce(heap: Float32Array, time: number): void {
    if (!this.struck) this.#begin(heap);
    if (!(this.bounces <= time)) this.bounces = time;
  }

  /** What Bullet's solver did beside what weight did. */
  #noteBounce(dt: number): void {
    const { gravity } = this.body;
    for (let i = 0; i < WIDTH; i++) {
      const weight = i < 3 ? gravity[i]! * dt : 0;
      const change = velocity[i]! - this.before[i]! - this.change[i]! - weight;
      this.change[i]! += change;
      this.late[i]! -= this.bounces * change;
    }
  }

  /** How far it is led back already along the normal of a point, metres. */
  lateAt(heap: Float32Array, point: ContactPoint): number {
    if (!this.struck) return 0;
    const o = (this.body.pointer + BODY.origin) >> 2;
    const [x, y, z] = [point.normal(0), point.normal(1), point.normal(2)];
    const rx = point.position(0) - heap[o]!;
    const ry = point.position(1) - heap[o + 1]!;
    const rz = point.position(2) - heap[o + 2]!;
    const [u, v, w, p, q, r] = this.late;
    return (
      x * (u! + q! * rz - r! * ry) + y * (v! + r! * rx - p! * rz) + z * (w! + p! * ry - q! * rx)
    );
  }

  /** Moves the body from where Bullet has taken it to where its hits take it. */
  makeUp({ reader, scratch }: Engine, dt: number): void {
    const { body, jointed, before, change, late } = this;
    // Those that hang on others that move had their blow alone: the joint solve brings the rest along.
    if (!this.struck || !body.active || this.hangs) return;
    reader.pose(body.body, body.pointer, pose, 0);
    reader.velocity(body.body, body.pointer, velocity, 0);
    if (this.bounces === this.bounces && !jointed) this.#noteBounce(dt);
    for (let i = 0; i < 3; i++) {
      pose[i]! += late[i]!;
      // The joint solve has its own account of weight.
      if (!jointed) pose[i]! -= (dt / 2) * (velocity[i]! - before[i]! - change[i]!);
      displacement[i] = late[3 + i]!;
    }
    writeTurn(turn, displacement, 1);
    multiply4(turn, turn, 0, pose, 3);
    body.body.setCenterOfMassTransform(scratch.transform(pose, turn));
  }

  #begin(heap: Float32Array): void {
    this.struck = true;
    this.struckIn = this.step;
    const v = (this.body.pointer + BODY.linearVelocity) >> 2;
    const w = (this.body.pointer + BODY.angularVelocity) >> 2;
    for (let i = 0; i < 3; i++) {
      this.before[i] = heap[v + i]!;
      this.before[3 + i] = heap[w + i]!;
    }
    this.change.fill(0);
    this.late.fill(0);
  }
}

/** A point where something round touches: whether it hits in this step, when, and how hard. */
export class Impact {
  readonly point: ContactPoint;
  a!: StruckBody;
  b!: StruckBody;
  bounce = 0;
  /** Approach speed that bounces at least, m/s. */
  least = 0;
  /** Metres at the start of the step; hits before this one move it to where its path leads back to. */
  gap = 0;
  /** Of the approach, m/s². */
  #pull = 0;
  /** Of what velocities in joints' middle of the step are ahead of those at its start, m/s. */
  #lead = 0;
  /** N s that went through it in this step. */
  impulse = 0;
  /** Part of the blow that is being worked out. */
  chained = false;
  /** Seconds after the start of the step, below 0 where it was missed in the step before. */
  time = 0;
  /** Approach at that time, m/s. */
  speed = 0;

  constructor(world: World) {
    this.point = new ContactPoint(world.engine.ammo);
  }

  get approach(): number {
    const { point } = this;
    return this.#lead - point.speed(point.normal(0), point.normal(1), point.normal(2));
  }

  weigh(dt: number): void {
    this.#pull = this.#lead = 0;
    this.#weigh(this.a, -1, dt);
    this.#weigh(this.b, 1, dt);
  }

  /** Of bodies in joints the joint solve hands over velocities of the step's middle, less what Bullet will add. */
  #weigh({ body, movable, jointed }: StruckBody, sign: 1 | -1, dt: number): void {
    if (!movable) return;
    const { point } = this;
    const [x, y, z] = body.gravity;
    const pull = sign * (x * point.normal(0) + y * point.normal(1) + z * point.normal(2));
    if (jointed) this.#lead += pull * dt;
    else this.#pull += pull;
  }

  /**
   * Whether it happens in this step of `dt` seconds, before `until`. What would be back within the step does not bounce but rests: it is
   * left to the solver, unless it comes faster than rest can be told from.
   */
  comes(dt: number, until: number): boolean {
    const { approach, gap } = this;
    const square = approach ** 2 + 2 * this.#pull * gap;
    const left = gap < 0 && square < 0;
    this.speed = left ? approach : Math.sqrt(square);
    if (!(this.speed >= OVER)) return false;
    if (approach >= 0) this.time = left ? 0 : (2 * gap) / (approach + this.speed);
    else if (gap >= 0 && this.#pull > 0) this.time = (this.speed - approach) / this.#pull;
    else return false;
    if (this.time < -dt) this.time = 0;
    return this.time < until && Math.max(2 * this.returned, this.speed / 2) > this.#pull * dt;
  }

  /** The share of the approach that has to stand in Bullet's row, so that weight leaves what is due after `dt`. */
  shareAt(dt: number): number {
    const { approach, returned, time } = this;
    return approach > 0 ? Math.max(0, returned - this.#pull * (dt - time)) / approach : 0;
  }

  /** m/s. */
  get returned(): number {
    return this.speed >= this.least ? this.bounce * this.speed : 0;
  }
}
