import { jointSolve } from '../effects/joints/effects.js';
import { POSE } from '../dynamics/poses.js';
import { VELOCITY } from '../engine/moving-bodies.js';
import type { World } from '../world/world.js';
import { SHOWN, STATE } from './messages.js';

/** Which bodies a page has to hear of, and where they are. */
export class Moved {
  /** By slot. */
  #due = new Uint8Array(16);

  /** Notes what the last frame is to draw. */
  note({ poses: { moved, movedCount } }: World): void {
    for (let i = 0; i < movedCount; i++) {
      const slot = moved[i]!;
      if (slot >= this.#due.length) this.#grow(slot);
      this.#due[slot] = 1;
    }
  }

  #grow(slot: number): void {
    const due = new Uint8Array(2 * slot + 2);
    due.set(this.#due);
    this.#due = due;
  }

  /** Writes the states of those that were noted. Returns how many they are, and the room, which may be another. */
  write(
    world: World,
    room: Float64Array<ArrayBuffer> = new Float64Array(0),
  ): { states: Float64Array<ArrayBuffer>; count: number } {
    const states = this.#roomFor(world, room);
    const { poses, bodies, registry } = world;
    const joints = registry.find(jointSolve);
    let count = 0;
    for (let slot = 0; slot < this.#due.length; slot++) {
      if (!this.#due[slot]) continue;
      this.#due[slot] = 0;
      const body = bodies.at(slot);
      if (!body) continue;
      const at = STATE * count++;
      states[at] = body.id;
      states[at + 1] = bodies.asleep(body) ? 1 : 0;
      for (let k = 0; k < POSE; k++) {
        states[at + 2 + k] = poses.previous[slot * POSE + k]!;
        states[at + 2 + POSE + k] = poses.current[slot * POSE + k]!;
      }
      const v = slot * VELOCITY;
      const shown = joints?.velocityOf(body);
      for (let k = 0; k < VELOCITY; k++) {
        states[at + 2 + 2 * POSE + k] = bodies.velocities[v + k]!;
        states[at + SHOWN + k] = shown
          ? shown.velocities[shown.at + k]!
          : bodies.velocities[v + k]!;
      }
    }
    return { states, count };
  }

  #roomFor({ poses }: World, room: Float64Array<ArrayBuffer>): Float64Array<ArrayBuffer> {
    const needed = (poses.current.length / POSE) * STATE;
    return room.length >= needed ? room : new Float64Array(needed);
  }
}
