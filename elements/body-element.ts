import type { Body, Drag, Vector, Velocities } from '../physics-core/index.js';
import type { PhysicsNode } from '../physics-core/inside.js';
import { X3DNodeElement } from './node-element.js';

/** A body's node, and what its element hands on to it. */
type BodyNode = PhysicsNode &
  Pick<
    Body,
    | 'applyForce'
    | 'applyTorque'
    | 'applyImpulse'
    | 'teleport'
    | 'drag'
    | 'wake'
    | 'sleep'
    | 'sleeping'
    | 'readPose'
  >;

/** The methods of a body; before it runs they do nothing. Arguments are in SI units and the world's frame. */
export class X3DBodyElement extends X3DNodeElement {
  get #body(): BodyNode | undefined {
    return (this.binding.node as BodyNode | null) ?? undefined;
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
  teleport(position: Vector, orientation?: Vector, velocities?: Velocities): void {
    this.#body?.teleport(position, orientation, velocities);
  }

  /** Takes hold of it at a point of the world, as `dragMode` says, until `end` or `cancel`. */
  drag(point: Vector): Drag | undefined {
    return this.#body?.drag(point);
  }

  /** Wakes it, and all that it fell asleep together with. */
  wake(): void {
    this.#body?.wake();
  }

  sleep(): void {
    this.#body?.sleep();
  }

  get sleeping(): boolean {
    return this.#body?.sleeping ?? false;
  }

  /** Position (3, metres) and quaternion (4, x y z w) of the last step into `out`, without allocating. */
  readPose<Out extends Float32Array | Float64Array | number[]>(out: Out): Out {
    return this.#body?.readPose(out) ?? out;
  }
}
