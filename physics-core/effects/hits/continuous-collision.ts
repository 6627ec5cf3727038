import { ContactPoint } from '../../engine/contact-point.js';
import { pairTestOf } from '../../engine/pair-test.js';
import { sweepOf } from '../../engine/sweep.js';
import { compose7 } from '../../base/flat-math.js';
import type { Body } from '../../dynamics/body.js';
import { POSE } from '../../dynamics/poses.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { areJoined, FastBodies } from './fast-bodies.js';

/** Of the greatest ball within a body: a little less does not catch on the floor that it slides along. */
const BALL = 0.9;

/**
 * Looks what lies on the way of bodies that pass more than half their own size in a step. Bullet's own way stops them
 * short and takes much of the speed that they should bounce with; here what they passed is a hit at its own time, as any
 * other. It is a ball within the body that is sent: what its ends strike as it turns is found by `swept ends`.
 */
export class ContinuousCollision extends FastBodies {
  readonly #simulation: Simulation;
  readonly #from = new Float64Array(POSE);
  readonly #pose = new Float64Array(POSE);
  #point: ContactPoint | undefined;

  constructor(simulation: Simulation) {
    super();
    this.#simulation = simulation;
  }

  /** A body will go far in the next step. */
  override need(body: Body, reason = 'passes more than half its size in a step'): void {
    super.need(body, reason);
  }

  /** Calls `visit` with a contact point for each that has passed something in the step, as deep as it came since. */
  look(visit: (pointer: number, a: number, b: number) => void): void {
    const { engine, bullet, poses } = this.#simulation;
    for (const node of this.causes) {
      const body = node as Body;
      if (!body.active || !body.movable || body.sleeping) continue;
      const radius = body.leastExtent / 2;
      compose7(this.#from, 0, poses.current, body.slot * POSE, body.centerOfMass);
      engine.reader.pose(body.pointer, this.#pose, 0);
      const sweep = sweepOf(engine);
      if (!sweep.send(bullet.bullet, body.body, BALL * radius, this.#from, this.#pose)) continue;
      const { met } = sweep;
      const other = this.#simulation.bodyAt(met);
      if (other && areJoined(body, other)) continue;
      const pointer = pairTestOf(engine).add(body.pointer, met);
      if (pointer === 0) return;
      this.#write(pointer, body.pointer, radius);
      visit(pointer, body.pointer, met);
    }
  }

  /** The plane in which they touched; gaps count from the ball's end of the way. */
  #write(pointer: number, body: number, radius: number): void {
    const { engine } = this.#simulation;
    const { met, position, normal } = sweepOf(engine);
    const point = (this.#point ??= new ContactPoint(engine.ammo));
    point.at(pointer, body, met);
    let gap = -radius;
    for (let i = 0; i < 3; i++) gap += normal[i]! * (this.#pose[i]! - position[i]!);
    for (let i = 0; i < 3; i++) {
      point.setNormal(i, normal[i]!);
      point.setPosition(i, position[i]!);
      point.setPositionOnA(i, position[i]! + normal[i]! * gap);
    }
    point.solverDistance = gap;
    point.impulse = 0;
    point.setLateralImpulses(0, 0);
    // Where there are several, the first speaks.
    point.setFirstChildren();
  }
}
