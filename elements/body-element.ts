import type { Drag, PhysicsNode } from '../physics-core/index.js';
import { X3DNodeElement } from './node-element.js';

type Vector = ArrayLike<number>;

/** World frame, m/s and rad/s. */
export interface BodyVelocities {
  linearVelocity?: Vector;
  angularVelocity?: Vector;
}

/** What a body's node can do. */
interface Body extends PhysicsNode {
  applyForce(force: Vector, at?: Vector): void;
  applyTorque(torque: Vector): void;
  applyImpulse(impulse: Vector, at?: Vector): void;
  teleport(position: Vector, orientation?: Vector, velocities?: BodyVelocities): void;
  drag(point: Vector): Drag | undefined;
  wake(): void;
  sleep(): void;
  readonly sleeping: boolean;
  readPose(out: Float32Array | Float64Array | number[]): typeof out;
}

/** The methods of a body; before it runs they do nothing. Arguments are in SI units and the world's frame. */
export class X3DBodyElement extends X3DNodeElement {
  get #body(): Body | undefined {
    return (this.binding.node as Body | null) ?? undefined;
  }

  /** Newtons, for the next step only; `at` is a point of the world, the centre of mass if left out. */
  applyForce(force: Vector, at?: Vector): void {
    this.#body?.applyForce(force, at);
  }

  /** Newton metres, for the next step only. */
  applyTorque(torque: Vector): void {
    this.#body?.applyTorque(torque);
  }

  /** Newton seconds, at once. */
  applyImpulse(impulse: Vector, at?: Vector): void {
    this.#body?.applyImpulse(impulse, at);
  }

  /**
   * Jumps there. What is left out stays as it is: its orientation (axis and angle), and each of its velocities. No edit of
   * the fields: `position` set to what it was last set to before does nothing after it, either.
   */
  teleport(position: Vector, orientation?: Vector, velocities?: BodyVelocities): void {
    this.#body?.teleport(position, orientation, velocities);
  }

  /** Takes hold of it at a point of the world, as `dragMode` says, until `end` or `cancel`. */
  drag(point: Vector): Drag | undefined {
    return this.#body?.drag(point);
  }

  wake(): void {
    this.#body?.wake();
  }

  sleep(): void {
    this.#body?.sleep();
  }

  get sleeping(): boolean {
    return this.#body?.sleeping ?? false;
  }

  /** Position and quaternion of the last step into `out`, without allocating. */
  readPose<Out extends Float32Array | Float64Array | number[]>(out: Out): Out {
    return (this.#body?.readPose(out) ?? out) as Out;
  }
}
