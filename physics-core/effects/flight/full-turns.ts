import { dot3, multiply4, writeTurn } from '../../base/flat-math.js';
import type { Body } from '../../dynamics/body.js';
import { POSE } from '../../dynamics/poses.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { BULLETS_TURN, turnByBullet } from '../../engine/turns.js';
import { Effect, type EffectDescriptor } from '../effect/effect.js';

/** What spins faster than Bullet turns bodies in a step is turned by the rest of it, about the same axis. */
export class FullTurns extends Effect {
  readonly #simulation: Simulation;
  readonly #pose = new Float64Array(POSE);
  readonly #velocity = new Float64Array(6);
  readonly #spin = new Float64Array(3);
  readonly #turn = new Float64Array(4);

  constructor(simulation: Simulation) {
    super();
    this.#simulation = simulation;
  }

  /** It turned far in the last step. */
  override need(body: Body, reason = 'turns far in a step'): void {
    super.need(body, reason);
  }

  override settle(dt: number): void {
    for (const node of this.causes) {
      const body = node as Body;
      if (body.active && body.movable && !body.sleeping) this.#turnOn(body, dt);
    }
  }

  #turnOn({ body, pointer }: Body, dt: number): void {
    const { reader, scratch } = this.#simulation.engine;
    const velocity = this.#velocity;
    reader.velocity(pointer, velocity, 0);
    const speed = Math.sqrt(dot3(velocity, 3, velocity, 3));
    if (!(speed * dt > BULLETS_TURN)) return;
    const pose = this.#pose;
    const turn = this.#turn;
    for (let i = 0; i < 3; i++) this.#spin[i] = velocity[3 + i]!;
    reader.pose(pointer, pose, 0);
    writeTurn(turn, this.#spin, dt - turnByBullet(speed * dt) / speed);
    multiply4(turn, turn, 0, pose, 3);
    body.setCenterOfMassTransform(
      scratch.transform([pose[0]!, pose[1]!, pose[2]!], [turn[0]!, turn[1]!, turn[2]!, turn[3]!]),
    );
  }
}

export const fullTurns: EffectDescriptor<FullTurns> = {
  name: 'full turns',
  causes: 'a body that turns by more than a sixteenth of a turn in a step',
  load: (simulation) => new FullTurns(simulation),
};
