import type { World } from '../../physics-core/inside.js';
import { applyInertia } from '../../physics-core/dynamics/inertia.js';
import type { BodyNode } from '../../physics-core/nodes/body/body.js';
import { add, cross, dot, length, subtract, type Pose } from '../../physics-core/base/math.js';
import { water } from '../../physics-core/effects/water/effects.js';
import { turnOf } from '../../physics-core/effects/drag/carried.js';
import type { Vec3 } from '../../physics-core/fields/types.js';

/** Speed of all bodies together that nobody need have put in, m/s: what a step does before its fall is reckoned. */
const UNEXPLAINED = 0.5;

/** More than what the author put in by this factor is a fault. */
const FACTOR = 4;

interface Moment {
  centre: Vec3;
  speed: Vec3;
  spin: number;
}

const centreOf = (body: BodyNode): Vec3 => body.centerOfMassWorld();

const velocities = (world: World, body: BodyNode): [Vec3, Vec3] => {
  const v = world.bodies.velocityOf(body);
  return [
    [v[0]!, v[1]!, v[2]!],
    [v[3]!, v[4]!, v[5]!],
  ];
};

/**
 * The energy that a scene's author puts in, joules: speeds, falls, forces, motors, what carried bodies push. Bodies that
 * have more motion than that times four have it of nobody.
 */
export class Ledger {
  readonly #world: World;
  /** Speeds, forces, motors and blows. */
  #given = 0;
  /** What gravity has done since the start, and the most of it so far. */
  #fallen = 0;
  #mostFallen = 0;
  #before = new Map<BodyNode, Moment>();
  /** Where bodies were after the last step. */
  #stood = new Map<BodyNode, Pose>();
  /** One-off forces of the next step. */
  #pushes: [body: BodyNode, force: Vec3, torque: Vec3][] = [];

  constructor(world: World) {
    this.#world = world;
  }

  #dynamic(): BodyNode[] {
    return [...this.#world.bodies].filter((body) => body.active && body.isDynamic);
  }

  motionOf(body: BodyNode): number {
    const [v, spin] = velocities(this.#world, body);
    return (body.mass.mass * dot(v, v) + dot(spin, applyInertia(body, spin))) / 2;
  }

  #motion(): number {
    return this.#dynamic().reduce((sum, body) => sum + this.motionOf(body), 0);
  }

  /** What an edit changes at once is given. */
  editing(edit: () => void): void {
    this.#world.flush();
    this.#noteNew();
    const before = this.#motion();
    edit();
    this.#world.flush();
    this.#given += Math.max(0, this.#motion() - before);
  }

  /** A force and a torque for one step. */
  push(body: BodyNode, force: Vec3, torque: Vec3, at: Vec3 | undefined): void {
    if (!body.active || !body.isDynamic) return;
    const arm: Vec3 = at ? subtract(at, centreOf(body)) : [0, 0, 0];
    this.#pushes.push([body, force, add(torque, cross(arm, force))]);
  }

  /** Where those are that came since the last step. */
  #noteNew(): void {
    for (const body of this.#world.bodies)
      if (!this.#stood.has(body)) this.#stood.set(body, body.pose());
  }

  beforeStep(): void {
    this.#noteNew();
    this.#before = new Map();
    for (const body of this.#world.bodies) {
      const [speed, spin] = velocities(this.#world, body);
      this.#before.set(body, {
        centre: centreOf(body),
        speed,
        spin: length(spin),
      });
    }
  }

  afterStep(): void {
    const { timeStep } = this.#world;
    const dynamic = this.#dynamic();
    for (const body of dynamic) this.#forces(body, timeStep);
    this.#mostFallen = Math.max(this.#mostFallen, this.#fallen);
    for (const node of this.#world.nodes) this.#motors(node, timeStep);
    for (const [body, force, torque] of this.#pushes) this.#push(body, force, torque, timeStep);
    this.#pushes = [];
    this.#given += this.#carried(timeStep, dynamic);
  }

  #way(body: BodyNode): number {
    const before = this.#before.get(body);
    return before && body.active ? length(subtract(before.centre, centreOf(body))) : 0;
  }

  #turn(body: BodyNode, timeStep: number): number {
    const spin = body.active ? length(velocities(this.#world, body)[1]) : 0;
    return Math.max(spin, this.#before.get(body)?.spin ?? 0) * timeStep;
  }

  #forces(body: BodyNode, timeStep: number): void {
    const before = this.#before.get(body);
    if (!before) return;
    const way = subtract(centreOf(body), before.centre);
    this.#fallen += body.mass.mass * dot(body.gravity, way);
    this.#given += this.#lifted(body, way, before.speed, timeStep);
    const { force, torque } = body.constantLoad;
    this.#given += length(force) * length(way) + length(torque) * this.#turn(body, timeStep);
    this.#given += this.#floated(body, length(way) + body.reach * this.#turn(body, timeStep));
  }

  /** Water lifts a body by the weight of what that displaces, wherever on it. */
  #floated(body: BodyNode, way: number): number {
    const carried = this.#world.registry.find(water)?.known(body)?.carried as number | undefined;
    return carried ? carried * length(this.#world.get('gravity') as Vec3) * way : 0;
  }

  /** What an overlap or a gap that edits left takes upwards without motion may fall down again. */
  #lifted(body: BodyNode, way: Vec3, before: Vec3, timeStep: number): number {
    const [after] = velocities(this.#world, body);
    const work = (v: Vec3): number => -body.mass.mass * dot(body.gravity, v);
    return Math.max(0, work(way) - timeStep * Math.max(0, work(before), work(after)));
  }

  /** Every motor at its strongest. */
  #motors(node: World['settings'], timeStep: number): void {
    const names = MOTORS[node.type.name];
    if (!names) return;
    const strength = names.reduce((sum, name) => sum + Math.abs(node.asked<number>(name)), 0);
    if (strength === 0) return;
    for (const name of ['body1', 'body2']) {
      const body = node.asked<BodyNode | null>(name);
      if (!body?.built) continue;
      const moved = node.type.name === 'SliderJoint' ? this.#way(body) : this.#turn(body, timeStep);
      this.#given += strength * moved;
    }
  }

  #push(body: BodyNode, force: Vec3, torque: Vec3, timeStep: number): void {
    if (!body.built) return;
    const [v, spin] = velocities(this.#world, body);
    const { mass, moments } = body.mass;
    const kick = length(force) * timeStep;
    const twist = length(torque) * timeStep;
    this.#given += kick * length(v) + kick ** 2 / (2 * mass);
    this.#given += twist * length(spin) + twist ** 2 / (2 * Math.min(...moments));
  }

  /** Metres and radians that edits took a body since the last step. */
  #told(body: BodyNode): [way: number, turn: number] {
    const from = this.#stood.get(body);
    if (!from) return [0, 0];
    const to = body.pose();
    return [length(subtract(to.p, from.p)), length(turnOf(from, to))];
  }

  /** Fixed bodies that are carried strike others at their own speed, which may throw these at twice that. */
  #carried(timeStep: number, dynamic: readonly BodyNode[]): number {
    let fastest = 0;
    for (const body of this.#world.bodies)
      if (body.kinematic) {
        const [v, spin] = velocities(this.#world, body);
        const [way, turn] = this.#told(body);
        const speed = Math.max(length(v), way / timeStep);
        fastest = Math.max(fastest, speed + REACH * Math.max(length(spin), turn / timeStep));
      }
    this.#stood = new Map([...this.#world.bodies].map((body) => [body, body.pose()]));
    return dynamic.reduce((sum, body) => sum + (body.mass.mass * (2 * fastest) ** 2) / 2, 0);
  }

  /** Joules of motion beyond four times what was put in; negative: all is well. */
  get #excess(): number {
    return this.#motion() - FACTOR * (this.#given + this.#mostFallen);
  }

  /** Speed at which all bodies together would have that much, m/s. */
  get excessSpeed(): number {
    const mass = this.#dynamic().reduce((sum, { mass: { mass } }) => sum + mass, 0);
    return mass > 0 ? Math.sqrt((2 * Math.max(0, this.#excess)) / mass) : 0;
  }

  /** What is wrong now; undefined: nothing. */
  fault(): string | undefined {
    if (!(this.excessSpeed > UNEXPLAINED)) return undefined;
    return `${this.#motion().toPrecision(3)} J of motion, of ${this.#given.toPrecision(3)} J given and ${this.#mostFallen.toPrecision(3)} J fallen`;
  }
}

/** Metres from the middle of a body to its rim. */
const REACH = 3;

const MOTORS: Record<string, readonly string[]> = {
  MotorJoint: ['axis1Torque', 'axis2Torque', 'axis3Torque'],
  DoubleAxisHingeJoint: ['maxTorque1', 'maxTorque2'],
  SliderJoint: ['sliderForce'],
};
