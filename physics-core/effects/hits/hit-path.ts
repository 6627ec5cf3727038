import { multiply4, place, writeTurn } from '../../base/flat-math.js';
import { writeAxes } from '../../base/matrix.js';
import { POSE } from '../../dynamics/poses.js';
import type { Engine } from '../../engine/engine.js';
import type { HitShape } from './hit-shape.js';
import type { StruckBody } from './struck-body.js';

/** Linear, then angular. */
const WIDTH = 6;

const rotation = new Float64Array(3);
const turn = new Float64Array(4);
const principal = new Float64Array(9);

/** Where one side of a hit is at a time of the step, led on with the velocity that it has now. */
export class HitPath {
  readonly #start = new Float64Array(POSE);
  readonly #velocity = new Float64Array(WIDTH);
  /** m/s². */
  readonly #pull = new Float64Array(3);
  readonly #now = new Float64Array(POSE);
  #late!: Float64Array;
  #struck = false;
  shape!: HitShape;
  /** The origin and the axes of its shape at that time. */
  readonly centre = new Float64Array(3);
  readonly axes = new Float64Array(9);

  /** Its author moves it, in one go before the step. */
  isDriven = false;

  begin({ reader }: Engine, link: StruckBody, shape: HitShape, dt: number): void {
    const { pointer } = link.body;
    this.shape = shape;
    this.#late = link.late;
    this.#struck = link.struck;
    reader.pose(pointer, this.#start, 0);
    reader.velocity(pointer, this.#velocity, 0);
    this.isDriven = !link.movable && this.#velocity.some(Boolean);
    const { gravity } = link.body;
    for (let i = 0; i < 3; i++) {
      const falls = link.movable ? gravity[i]! : 0;
      // Of bodies in joints the joint solve hands over velocities of the step's middle, less what Bullet will add.
      if (link.jointed) this.#velocity[i]! += falls * dt;
      this.#pull[i] = link.jointed ? 0 : falls;
    }
  }

  /** What lies on something else does not fall. */
  stay(): void {
    this.#pull.fill(0);
  }

  /** So many seconds after the start of the step. */
  at(time: number): void {
    for (let i = 0; i < 3; i++) {
      const late = this.#struck ? this.#late[i]! : 0;
      const fallen = (this.#pull[i]! * time * time) / 2;
      this.#now[i] = this.#start[i]! + late + this.#velocity[i]! * time + fallen;
    }
    if (this.shape.central) this.centre.set(this.#now.subarray(0, 3));
    else this.#turn(time);
  }

  #turn(time: number): void {
    for (let i = 0; i < 3; i++) {
      const late = this.#struck ? this.#late[3 + i]! : 0;
      rotation[i] = late + this.#velocity[3 + i]! * time;
    }
    writeTurn(turn, rotation, 1);
    multiply4(turn, turn, 0, this.#start, 3);
    for (let i = 0; i < 4; i++) this.#now[3 + i] = turn[i]!;
    writeAxes(principal, this.#now, 3);
    place(this.centre, this.axes, this.#now, principal, this.shape.frame);
  }

  /** From the centre of mass to a point. */
  writeArm(out: Float64Array, point: Float64Array): void {
    for (let i = 0; i < 3; i++) out[i] = point[i]! - this.#now[i]!;
  }

  /** Velocity along a normal of the material at an arm, m/s. */
  speed(arm: Float64Array, normal: Float64Array, time: number): number {
    const v = this.#velocity;
    let sum = 0;
    for (let i = 0; i < 3; i++) {
      const j = (i + 1) % 3;
      const k = (i + 2) % 3;
      const turning = v[3 + j]! * arm[k]! - v[3 + k]! * arm[j]!;
      sum += normal[i]! * (v[i]! + this.#pull[i]! * time + turning);
    }
    return sum;
  }

  /** m/s². */
  pullAlong(normal: Float64Array): number {
    return this.#pull[0]! * normal[0]! + this.#pull[1]! * normal[1]! + this.#pull[2]! * normal[2]!;
  }
}
