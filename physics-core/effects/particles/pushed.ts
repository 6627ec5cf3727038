import { isHeld } from '../../dynamics/jointed.js';
import { add, rotate, subtract, type Quaternion } from '../../base/math.js';
import type { Vec3 } from '../../fields/types.js';
import type { Body } from '../../dynamics/body.js';
import { inverseInertiaOf } from '../../dynamics/inertia.js';
import { POSE } from '../../dynamics/poses.js';
import type { Simulation } from '../../dynamics/simulation.js';
import type { Effects } from '../effect/effects.js';
import { jointSolve } from '../joints/effects.js';
import { MET } from './collide/obstacles.js';

/** A body that particles push in a step. */
interface PushedBody {
  readonly body: Body;
  readonly inverseMass: number;
  /** Of the world's axes, a column each: what a moment about it does to the spin. */
  readonly inverseInertia: Float64Array;
  /** Its centre of mass at the end of the step, and the way of that in the step, metres. */
  readonly centre: Vec3;
  readonly way: Vec3;
  /** N s, and about the centre of mass N m s. */
  readonly impulse: Vec3;
  readonly moment: Vec3;
}

const arm = new Float64Array(3);
const moment = new Float64Array(3);
const spin = new Float64Array(3);
const given = new Float64Array(3);

/** What particles give to bodies in a step: each hears of it once, when the step is over. */
export class Pushed {
  readonly #simulation: Simulation;
  readonly #effects: Effects;
  readonly #bySlot = new Map<number, PushedBody | undefined>();

  constructor(simulation: Simulation, effects: Effects) {
    this.#simulation = simulation;
    this.#effects = effects;
  }

  #in(slot: number): PushedBody | undefined {
    if (this.#bySlot.has(slot)) return this.#bySlot.get(slot);
    const body = this.#simulation.bodies.in(slot);
    const pushed = body?.isDynamic ? pushedOf(body, this.#simulation) : undefined;
    this.#bySlot.set(slot, pushed);
    return pushed;
  }

  /** Adds what was given to a body already in this step to its velocity where it was met, m/s. */
  addVelocity(met: Float64Array, out: Float64Array): void {
    const pushed = this.#in(met[MET.body]!);
    if (!pushed) return;
    armTo(met, pushed);
    const { inverseMass, impulse } = pushed;
    turn(pushed.inverseInertia, pushed.moment, spin);
    out[0] = out[0]! + inverseMass * impulse[0] + spin[1]! * arm[2]! - spin[2]! * arm[1]!;
    out[1] = out[1]! + inverseMass * impulse[1] + spin[2]! * arm[0]! - spin[0]! * arm[2]!;
    out[2] = out[2]! + inverseMass * impulse[2] + spin[0]! * arm[1]! - spin[1]! * arm[0]!;
  }

  /**
   * The same along the normal alone: along the surface what the body stands on may hold it, and would not hold what lies on it.
   */
  addNormalVelocity(met: Float64Array, out: Float64Array): void {
    given.fill(0);
    this.addVelocity(met, given);
    let speed = 0;
    for (let i = 0; i < 3; i++) speed += given[i]! * met[MET.normal + i]!;
    for (let i = 0; i < 3; i++) out[i] = out[i]! + speed * met[MET.normal + i]!;
  }

  /** What a push of 1 N s along a direction does to the speed of the body along it, where it was met: 1/kg. */
  softness(met: Float64Array, direction: Float64Array, at: number): number {
    const pushed = this.#in(met[MET.body]!);
    if (!pushed) return 0;
    armTo(met, pushed);
    crossWith(direction, at);
    turn(pushed.inverseInertia, moment, spin);
    return (
      pushed.inverseMass + spin[0]! * moment[0]! + spin[1]! * moment[1]! + spin[2]! * moment[2]!
    );
  }

  /** So many N s along a direction, where it was met. */
  push(met: Float64Array, direction: Float64Array, at: number, impulse: number): void {
    const pushed = this.#in(met[MET.body]!);
    if (!pushed) return;
    armTo(met, pushed);
    crossWith(direction, at);
    for (let i = 0; i < 3; i++) {
      pushed.impulse[i] = pushed.impulse[i]! + impulse * direction[at + i]!;
      pushed.moment[i] = pushed.moment[i]! + impulse * moment[i]!;
    }
  }

  /** Bodies get what was given to them. */
  end(): void {
    for (const pushed of this.#bySlot.values()) {
      if (!pushed) continue;
      const { impulse, moment: about } = pushed;
      if (impulse.some(Boolean) || about.some(Boolean)) this.#kick(pushed.body, impulse, about);
    }
    this.#bySlot.clear();
  }

  #kick(body: Body, impulse: Vec3, about: Vec3): void {
    const { engine, bodies } = this.#simulation;
    if (body.sleeping) body.wake();
    if (isHeld(body)) this.#effects.find(jointSolve)?.loadChanges(body);
    body.body.applyCentralImpulse(engine.scratch.vector(...impulse));
    body.body.applyTorqueImpulse(engine.scratch.vector(...about));
    bodies.readVelocity(body);
  }
}

function pushedOf(body: Body, simulation: Simulation): PushedBody {
  return {
    body,
    inverseMass: 1 / body.mass.mass,
    inverseInertia: inverseInertiaOf(body),
    centre: body.centerOfMassWorld(),
    way: wayOf(body, simulation),
    impulse: [0, 0, 0],
    moment: [0, 0, 0],
  };
}

/** How far its centre of mass has come in the step that was taken. */
function wayOf(body: Body, { poses: { previous, current } }: Simulation): Vec3 {
  const at = body.slot * POSE;
  const { p } = body.centerOfMass;
  const placeIn = (poses: Float64Array): Vec3 => {
    const [x, y, z, ...q] = poses.subarray(at, at + POSE) as unknown as number[];
    return add([x!, y!, z!], rotate(q as unknown as Quaternion, p));
  };
  return subtract(placeIn(current), placeIn(previous));
}

/** From where the centre was when it was met. */
function armTo(met: Float64Array, { centre, way }: PushedBody): void {
  const left = 1 - met[MET.time]!;
  for (let i = 0; i < 3; i++) arm[i] = met[MET.point + i]! - (centre[i]! - left * way[i]!);
}

function crossWith(direction: Float64Array, at: number): void {
  const x = direction[at]!;
  const y = direction[at + 1]!;
  const z = direction[at + 2]!;
  moment[0] = arm[1]! * z - arm[2]! * y;
  moment[1] = arm[2]! * x - arm[0]! * z;
  moment[2] = arm[0]! * y - arm[1]! * x;
}

function turn(columns: Float64Array, v: ArrayLike<number>, out: Float64Array): void {
  for (let i = 0; i < 3; i++)
    out[i] = columns[i]! * v[0]! + columns[3 + i]! * v[1]! + columns[6 + i]! * v[2]!;
}
