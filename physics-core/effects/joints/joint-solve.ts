import type { Body } from '../../dynamics/body.js';
import type { Joint } from '../../dynamics/joint.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { Effect, type Cause, type EffectDescriptor } from '../effect/effect.js';
import type { Effects } from '../effect/effects.js';
import { stops } from './stops.js';
import { PostStabilization } from './post-stabilization.js';
import { BoundedRows, isBounded } from './bounded-rows.js';
import { BulletTargets } from './bullet-targets.js';
import { Forest, type Component, type Edge } from './forest.js';
import { JointEnds } from './joint-ends.js';
import { holds } from '../../dynamics/jointed.js';
import { LockedRows } from './locked-rows.js';
import { JointedBodies } from './jointed-bodies.js';
import { NextPoses } from './next-poses.js';
import { isPin, PointConstraints } from './point-constraints.js';
import { RowSystem } from './row-system.js';
import { SleepingRows } from './sleeping-rows.js';
import { GeometricStiffness } from './geometric-stiffness.js';

/**
 * Rounds, at most, in which the rates asked for are corrected by how far the step would miss. Each gains two digits at the
 * usual speeds, less where a body turns by half a radian in a step.
 */
const ROUNDS = 8;

/** A miss (m, rad) that single precision hardly tells apart ten metres from the origin. */
const NO_MISS = 1e-6;

/** Errors (m, rad) from which on a joint counts as torn by an edit: what steps leave is a hundred times less. */
const TORN = 1e-4;

/** Misses (m, rad) that a step may leave where its rounds do not find together. */
const LEFT_OPEN = 1e-5;

/** Pulls at bodies that joints hold, by more than a force: their joints give way to it as they can. */
export interface Pull {
  /** Body number `i` of the system. */
  pullIn(body: Body, system: RowSystem, i: number, dt: number): void;
}

/**
 * Solves all joints directly, before each step of Bullet: the velocities it hands over carry the bodies, along their
 * round ways, to where every joint is whole (SHAKE, with the direct solution of its rows in place of iterations).
 * Bullet's own constraints are told to aim at those velocities: they stay on for what contacts do in the step.
 */
export class JointSolve extends Effect {
  readonly #effects: Effects;
  readonly #system = new RowSystem();
  readonly #forest = new Forest();
  readonly #ends = new JointEnds();
  readonly #bodies: JointedBodies;
  readonly #next: NextPoses;
  readonly #stabilization: PostStabilization;
  readonly #pins: PointConstraints;
  readonly #rows: LockedRows;
  readonly #bounded: BoundedRows;
  readonly #stiffness: GeometricStiffness;
  /** Bullet's own rows. */
  readonly #sleepingRows: SleepingRows;
  /** What pulls at bodies by more than a force. */
  readonly pulls = new Set<Pull>();
  #joints: (Joint | undefined)[] = [];
  /** Those of this step: solved, and of them those that an edit had torn. */
  readonly #solved: Component[] = [];
  readonly #repaired: Component[] = [];
  readonly #alone = new Set<Body>();
  /** And those whose round ways could not be met: the step leaves them open. */
  readonly #open = new Set<Component>();
  #stale = true;

  constructor(simulation: Simulation, effects: Effects) {
    super();
    this.#effects = effects;
    this.#bodies = new JointedBodies(simulation, this.#system);
    this.#next = new NextPoses(this.#system, this.#bodies);
    this.#stabilization = new PostStabilization(simulation, this.#system, this.#bodies);
    this.#pins = new PointConstraints(this.#system.pins, this.#bodies, this.#next);
    this.#rows = new LockedRows(this.#system, this.#bodies, this.#next, this.#ends);
    this.#bounded = new BoundedRows(this.#system, this.#bodies, this.#rows);
    this.#stiffness = new GeometricStiffness(this.#system, this.#bodies);
    const targets = new BulletTargets(this.#system, this.#bodies, this.#ends);
    this.#sleepingRows = new SleepingRows(simulation, this.#bodies, targets);
  }

  /** A joint came, or holds otherwise than before; its stops or motors are others, or who of its bodies moves. */
  override need(joint: Joint, reason: string): void {
    this.#stale = true;
    super.need(joint, reason);
  }

  override release(node: Cause): void {
    if (!this.isNeededBy(node)) return;
    this.#stale = true;
    super.release(node);
    const k = this.#joints.indexOf(node as Joint);
    if (k >= 0) this.#joints[k] = undefined;
  }

  /** What a joint did is not to be known when it comes again. Bodies lose their joints before they go. */
  override unmade(node: Cause): void {
    this.relaunch(node);
    this.release(node);
  }

  /** An immovable body was moved: its ends of joints go along. */
  carried(body: Body): void {
    if (this.#stale) return;
    this.#joints.forEach((joint, k) => {
      if (joint?.body1 !== body && joint?.body2 !== body) return;
      this.#ends.takeFrames(k, joint!);
      if (this.#system.isPin[k]) this.#pins.takePoints(k, joint!, this.#ends.edges[k]!);
    });
  }

  /** Seconds of a body's last step, to the middle of which its velocity belongs; 0: to this moment. */
  lastStep(body: Body): number {
    return this.#bodies.lastStep(body);
  }

  setLastStep(body: Body, seconds: number): void {
    this.#bodies.setLastStep(body, seconds);
  }

  /** Its velocity is given anew. */
  relaunch(body: Cause): void {
    this.#bodies.relaunch(body as Body);
  }

  /** Whether nothing but joints and forces acted, in the last step, on a body and what it hangs together with. */
  alone(body: Body): boolean {
    return this.active && this.#alone.has(body);
  }

  /** FALSE leaves joints to Bullet's own iterations: for comparing the two. */
  on = true;

  override beforeStep(dt: number): void {
    if (this.#stale) this.#rebuild();
    this.#repaired.length = 0;
    this.#solved.length = 0;
    this.#open.clear();
    for (const component of this.#forest.components)
      if (this.on && !this.#bodies.asleep(component)) this.#solve(component, dt);
      else this.#sleepingRows.hold(component);
  }

  /** What contacts did to joints in the step, and what the step itself left open, is brought together here. */
  override settle(dt: number): void {
    this.#alone.clear();
    for (const component of this.#solved) {
      const disturbed = this.#stabilization.disturbed(component, dt);
      if (!disturbed) for (const i of component.bodies) this.#alone.add(this.#bodies.bodies[i]!);
      if (this.#open.has(component)) this.#close(component, dt, LEFT_OPEN);
      else if (disturbed) this.#close(component, dt, TORN);
    }
  }

  /** Moves the bodies of a component to where its joints are whole, but for errors smaller than `least`. */
  #close(component: Component, dt: number, least: number): void {
    for (let round = 0; round < ROUNDS; round++) {
      let worst = 0;
      this.#read(component, dt);
      for (const k of component.pins) {
        worst = Math.max(worst, this.#pins.fill(k));
        this.#pins.setWholeTargets(k);
      }
      for (const k of component.rows) {
        worst = Math.max(worst, this.#rows.fill(k), this.#bounded.fill(k, dt));
        this.#rows.setWholeTargets(k);
        this.#bounded.setWholeTargets(k);
      }
      if (worst < least) return;
      this.#stabilization.clearMomentum(component);
      if (!this.#system.solve(component) || !this.#bodies.sane(component)) return;
      this.#stabilization.move(component);
    }
  }

  /** What was moved together again shall not go on moving. */
  override afterStep(): void {
    for (const component of this.#repaired) this.#stabilization.takeBack(component);
  }

  #solve(component: Component, dt: number): void {
    const torn = this.#fill(component, dt) > TORN;
    this.#bodies.noteStep(component, dt);
    this.#setTargets(component, dt, torn ? 0 : 1);
    const found = this.#find(component, dt, torn ? 0 : 1);
    if (!found || !(torn ? this.#repair(component, dt) : this.#land(component, dt))) {
      this.#leaveToBullet(component);
      return;
    }
    this.#bodies.write(component, dt);
    if (this.#repaired.includes(component)) this.#stabilization.note(component);
    this.#solved.push(component);
    this.#sleepingRows.solved(component, dt);
    for (const k of component.rows) this.#bounded.tell(k, this.#effects.get(stops));
  }

  /** Returns the worst error of a joint. */
  #fill(component: Component, dt: number): number {
    let worst = 0;
    this.#read(component, dt);
    for (const k of component.pins) {
      worst = Math.max(worst, this.#pins.fill(k));
      this.#stiffness.stiffenPin(k, dt);
    }
    for (const k of component.rows) {
      worst = Math.max(worst, this.#rows.fill(k), this.#bounded.fill(k, dt));
      if (!this.#system.isPin[k]) this.#stiffness.stiffen(k, this.#ends.geometry.two.origin, dt);
    }
    this.#drag(component, dt);
    return worst;
  }

  #read(component: Component, dt: number): void {
    this.#bodies.read(component, dt);
    this.#system.resisting.clear();
  }

  /** What somebody pulls at. */
  #drag({ bodies }: Component, dt: number): void {
    for (const pull of this.pulls)
      for (const i of bodies) pull.pullIn(this.#bodies.bodies[i]!, this.#system, i, dt);
  }

  #setTargets(component: Component, dt: number, repair: 0 | 1): void {
    for (const k of component.pins) this.#pins.setTargets(k, dt, repair);
    for (const k of component.rows) {
      this.#rows.setTargets(k, dt, repair);
      this.#bounded.setTargets(k, dt, repair);
    }
  }

  /** False: no solution that makes sense. */
  #find(component: Component, dt: number, repair: 0 | 1): boolean {
    if (!this.#system.solve(component)) return false;
    this.#correctNonlinearly(component, dt, repair);
    // The repair of a torn joint is no pull.
    if (!this.#repaired.includes(component)) {
      for (const k of component.pins) this.#stiffness.notePin(k);
      for (const k of component.rows) if (!this.#system.isPin[k]) this.#stiffness.note(k);
    }
    return this.#bodies.sane(component);
  }

  /** Corrects the rates by how far the step would miss, as long as that helps: where bodies turn too far, energy suffers. */
  #correctNonlinearly(component: Component, dt: number, repair: 0 | 1): void {
    let first = Infinity;
    let before = Infinity;
    for (let round = 0; round < ROUNDS; round++) {
      const worst = this.#correct(component, dt, repair);
      if (worst > first) this.#forgetCorrections(component, dt, repair);
      if (worst < LEFT_OPEN) this.#open.delete(component);
      else this.#open.add(component);
      if (worst < NO_MISS || worst > before) return;
      this.#system.again(component);
      if (round === 0) first = worst;
      before = worst;
    }
  }

  /** Returns by how much the velocities found miss. */
  #correct(component: Component, dt: number, repair: 0 | 1): number {
    this.#next.predict(component, dt);
    let worst = 0;
    for (const k of component.pins) worst = Math.max(worst, this.#pins.correct(k, dt, repair));
    for (const k of component.rows) worst = Math.max(worst, this.#rows.correct(k, dt, repair));
    return worst;
  }

  #forgetCorrections(component: Component, dt: number, repair: 0 | 1): void {
    for (const k of component.pins) this.#pins.forgetCorrections(k);
    for (const k of component.rows) this.#rows.forgetCorrections(k);
    this.#setTargets(component, dt, repair);
    this.#system.again(component);
  }

  /** Joints that an edit tore apart come together in the step, but what that takes is no motion of the bodies. */
  #repair(component: Component, dt: number): boolean {
    this.#repaired.push(component);
    this.#stabilization.keep(component);
    this.#setTargets(component, dt, 1);
    for (const k of component.rows) this.#bounded.setRepairTargets(k, dt);
    return this.#find(component, dt, 1);
  }

  /** What meets a stop within the step is thrown back there: the step takes it elsewhere than its rate after it would. */
  #land(component: Component, dt: number): boolean {
    if (!this.#bounded.setLandingTargets(component)) return true;
    this.#repaired.push(component);
    this.#stabilization.keep(component);
    return this.#find(component, dt, 1);
  }

  /** For this step: Bullet's own rows and velocities stand. */
  #leaveToBullet(component: Component): void {
    const at = this.#repaired.indexOf(component);
    if (at >= 0) this.#repaired.splice(at, 1);
    this.#sleepingRows.reset(component);
    // Who brought numbers that are none is told so by another.
    if (!this.#bodies.finite) return;
    const joint = this.#joints[component.joints[0]!]!;
    joint.report({
      code: 'joint-solve',
      severity: 'warning',
      used: "Bullet's iterations",
      message: `${joint.label} and the joints it hangs together with have no direct solution; they are held less well`,
    });
  }

  /** Whether some of Bullet's rows are let go: the first touch finds them on. */
  override seesContacts(): boolean {
    return this.#sleepingRows.waits;
  }

  override contact(_point: number, a: number, b: number): boolean {
    this.#sleepingRows.touch(a);
    this.#sleepingRows.touch(b);
    return true;
  }

  #rebuild(): void {
    this.#stale = false;
    const joints = [...this.causes] as Joint[];
    const numbers = new Map<Body, number>();
    const number = (body: Body | undefined): number => {
      if (!body?.movable) return -1;
      if (!numbers.has(body)) numbers.set(body, numbers.size);
      return numbers.get(body)!;
    };
    const edges: Edge[] = joints.map((joint) => ({
      a: number(joint.body1),
      b: number(joint.body2),
      pin: isPin(joint),
      rows: joint.lockedRows.length > 3 || isBounded(joint),
    }));
    this.#forest.build(numbers.size, edges);
    this.#system.resize(numbers.size, edges, this.#forest);
    this.#bodies.take([...numbers.keys()]);
    this.#next.take(numbers.size, edges, this.#forest.components);
    this.#stabilization.take(numbers.size);
    this.#ends.take(joints, edges);
    this.#pins.take(joints, edges, this.#forest);
    this.#rows.take(joints);
    this.#bounded.take(joints);
    this.#stiffness.take(this.#joints, joints);
    this.#sleepingRows.take(joints, this.#forest);
    this.#joints = joints;
  }
}

export const jointSolve: EffectDescriptor<JointSolve> = {
  name: 'joint solve',
  causes: 'a joint that holds: it stands in the world and some row of it is locked',
  after: {
    forces: 'it reads what pushes its bodies in the step',
    suspension: 'the same',
    dragging: 'the same',
    motors: 'the same',
    'gyroscopic torque': 'it begins with the spin of free motion',
    'chains of hits': 'what was hit is where its hits take it before joints are closed',
    'pair filter': 'a contact that is taken back wakes none of its rows',
  },
  joint: (joint) => (holds(joint) ? 'joint' : undefined),
  load: (simulation, effects) => new JointSolve(simulation, effects),
};
