import { doublesOf, pack } from '../../base/packed.js';
import { guards } from '../../base/guards.js';
import type { Body } from '../../dynamics/body.js';
import type { Joint } from '../../dynamics/joint.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { BoundedRows, type Bound, type StopListener } from './bounded-rows.js';
import { ROWS } from '../../solver/joints/blocks.js';
import { BulletTargets } from './bullet-targets.js';
import { EnergyBudget } from './energy-budget.js';
import type { Component, Edge, Forest } from '../../solver/joints/forest.js';
import { GeometricStiffness } from './geometric-stiffness.js';
import { JointedBodies } from './jointed-bodies.js';
import { JointClosing } from './joint-closing.js';
import { JointEnds, type Ways } from './joint-ends.js';
import { LockedRows } from './locked-rows.js';
import { NextPoses } from './next-poses.js';
import { PointConstraints } from './point-constraints.js';
import { PostStabilization } from './post-stabilization.js';
import { Recent } from '../../solver/joints/recent.js';
import { RowSystem } from '../../solver/joints/row-system.js';
import { ShakenPivots } from './shaken-pivots.js';
import { TornJoints } from './torn-joints.js';
import { YieldingBodies, type Yields } from './yielding-bodies.js';
import { LEFT_OPEN, NO_MISS, VelocitySearch } from './velocity-search.js';

/** Rounds, at most, in which what has too much energy is slowed. */
const SLOWING_ROUNDS = 3;

/** Errors (m, rad) from which on a joint counts as torn by an edit: what steps leave is a hundred times less. */
const TORN = 1e-4;

/** And what is brought together again after contacts had their part in a step. */
const DISTURBED = 2e-5;

/** Bodies of a chain from which on its end may be faster than steps can follow (60 gain 4 % at `reference`, 120 fourteen times). */
const LONG = 24;

/** A body as a step begins with it: where its numbers stand in those of all. */
export interface Ahead {
  inertia: Float64Array;
  momentum: Float64Array;
  velocity: Float64Array;
  i: number;
}

/** Pulls at bodies that joints hold, by more than a force: their joints give way to it as they can. */
export interface Pull {
  /** Body number `i` of the system. */
  pullIn(body: Body, system: RowSystem, i: number, dt: number): void;
  /** Whether it pulls at a body. */
  pullsAt(body: Body): boolean;
}

/** What is known of a component from the steps before. */
export interface KeptComponent {
  /** Steps. */
  taut: number;
  mended: number;
  disturbed: boolean;
  led: boolean;
  /** Joules, packed. */
  account?: string;
}

/** Solves the joints of one component after the other: finds the velocities that take its bodies to where they are whole. */
export class ComponentSolve {
  readonly #simulation: Simulation;
  readonly #system = new RowSystem();
  readonly #ends = new JointEnds();
  readonly bodies: JointedBodies;
  /** What Bullet's own rows are to aim at. */
  readonly targets: BulletTargets;
  readonly #next: NextPoses;
  readonly #stabilization: PostStabilization;
  readonly #pins: PointConstraints;
  readonly #rows: LockedRows;
  readonly #bounded: BoundedRows;
  readonly #stiffness: GeometricStiffness;
  readonly #shaken: ShakenPivots;
  readonly #budget: EnergyBudget;
  readonly #search: VelocitySearch;
  readonly #closing: JointClosing;
  readonly #tornJoints: TornJoints;
  readonly #yields: YieldingBodies;
  /** What pulls at bodies by more than a force. */
  readonly pulls = new Set<Pull>();
  /** Those of this step that an edit had torn, or that met a stop. */
  readonly #repaired: Component[] = [];
  /** Those that an edit had torn. */
  readonly torn = new Set<Component>();
  /** Loops that an edit had torn a few steps ago. */
  readonly #mended = new Recent();
  /** Those that were led on in the last step: in this one they mostly are again, and round ways are seen to then. */
  readonly #led = new Set<Component>();
  /** Those that contacts moved in the last step: gaps of theirs are no edit's. */
  readonly #disturbed = new Set<Component>();

  /** `of`: it is asked for the velocities that those bodies have when their step is over. */
  constructor(simulation: Simulation, of?: JointedBodies) {
    this.#simulation = simulation;
    this.bodies = new JointedBodies(simulation, this.#system, of);
    this.#next = new NextPoses(this.#system, this.bodies);
    this.#stabilization = new PostStabilization(simulation, this.#system, this.bodies);
    this.#pins = new PointConstraints(this.#system, this.bodies, this.#next);
    this.#rows = new LockedRows(this.#system, this.bodies, this.#next, this.#ends);
    this.#bounded = new BoundedRows(this.#system, this.bodies, this.#rows);
    this.#stiffness = new GeometricStiffness(this.#system, this.bodies);
    this.#shaken = new ShakenPivots(this.#system, this.#pins, this.#bounded);
    const parts = {
      system: this.#system,
      bodies: this.bodies,
      pins: this.#pins,
      rows: this.#rows,
      bounded: this.#bounded,
    };
    this.#search = new VelocitySearch({ ...parts, next: this.#next });
    this.#closing = new JointClosing({ ...parts, stabilization: this.#stabilization });
    this.#tornJoints = new TornJoints(simulation, this.#system, this.bodies);
    this.#yields = new YieldingBodies(this.#system, this.bodies);
    this.#budget = new EnergyBudget(this.#system, this.bodies);
    this.targets = new BulletTargets(this.#system, this.bodies, this.#ends);
  }

  // ---- what there is ------------------------------------------------------------------------------------------------

  /** Bodies and joints are numbered anew; `before`: the joints as they were numbered. */
  take(
    bodies: Body[],
    joints: readonly Joint[],
    before: readonly (Joint | undefined)[],
    edges: Edge[],
    forest: Forest,
  ): void {
    this.#system.resize(bodies.length, edges, forest);
    this.bodies.take(bodies);
    this.#next.take(bodies.length, edges, forest.components);
    this.#stabilization.take(bodies.length);
    this.#tornJoints.take(bodies.length);
    this.#ends.take(joints, edges);
    this.#pins.take(joints, edges, forest);
    this.#rows.take(joints);
    this.#bounded.take(joints);
    this.#stiffness.take(before, joints);
    this.#shaken.take(bodies.length);
    this.#budget.forget();
    this.#search.taut.forget();
    this.#mended.forget();
    this.#disturbed.clear();
    this.#led.clear();
  }

  // ---- from step to step ----------------------------------------------------------------------------------------------

  /** How a joint pulled: three numbers. */
  pullsOf(k: number): Float64Array {
    return this.#stiffness.pulls.slice(3 * k, 3 * k + 3);
  }

  setPulls(k: number, pulls: Float64Array): void {
    this.#stiffness.pulls.set(pulls, 3 * k);
  }

  /** What the next step asks of the last one about a joint. */
  keepJoint(k: number): Float64Array {
    const parts = this.#lasting(k);
    return Float64Array.from([...parts.flatMap((part) => [...part]), ...this.#system.keep(k)]);
  }

  loadJoint(k: number, kept: Float64Array): void {
    let at = 0;
    for (const part of this.#lasting(k)) {
      part.set(kept.subarray(at, at + part.length));
      at += part.length;
    }
    this.#system.goOn(k, kept, at);
  }

  #lasting(k: number): Float64Array[] {
    const of = (all: Float64Array, width: number): Float64Array =>
      all.subarray(k * width, (k + 1) * width);
    return [
      ...this.#pins.lasting.map((each) => of(each, 3)),
      of(this.#rows.lasting, ROWS),
      of(this.#bounded.lasting, ROWS),
    ];
  }

  /** The same about a component; undefined: nothing. */
  keepComponent(component: Component): KeptComponent | undefined {
    const taut = this.#search.taut.left(component);
    const mended = this.#mended.left(component);
    const disturbed = this.#disturbed.has(component);
    const led = this.#led.has(component);
    const account = this.#budget.keep(component);
    if (!taut && !mended && !disturbed && !led && !account) return undefined;
    return { taut, mended, disturbed, led, ...(account && { account: pack(account) }) };
  }

  loadComponent(
    component: Component,
    { taut, mended, disturbed, led, account }: KeptComponent,
  ): void {
    this.#search.taut.goOn(component, taut);
    this.#mended.goOn(component, mended);
    if (disturbed) this.#disturbed.add(component);
    if (led) this.#led.add(component);
    if (account) this.#budget.goOn(component, doublesOf(account));
  }

  /** Where joint `k` holds on to an immovable body is elsewhere, or on its way. */
  takeEnds(k: number, joint: Joint, ways?: Ways): void {
    this.#ends.takeFrames(k, joint, ways);
    if (this.#system.isPin[k]) this.#pins.takePoints(k, joint, this.#ends.edges[k]!, ways);
  }

  // ---- around a step ------------------------------------------------------------------------------------------------

  begin(): void {
    this.#repaired.length = 0;
    this.torn.clear();
    this.#search.open.clear();
  }

  /** Hands the velocities found to Bullet. False: there are none that make sense. */
  solve(component: Component, dt: number): boolean {
    const torn = this.#isTorn(component, this.#fill(component, dt));
    this.#system.firm = this.#search.taut.goesOn(component);
    this.#shaken.lean(component, dt);
    const free = this.#isFree(component);
    if (free) this.#budget.begin(component);
    else this.#budget.forget(component);
    this.bodies.noteStep(component, dt);
    this.#search.setTargets(component, dt, torn ? 0 : 1);
    this.#search.roughly = !torn && this.#led.has(component);
    const found = this.#find(component, dt, torn ? 0 : 1);
    this.#search.roughly = false;
    const closed = found && (torn ? this.#repair(component, dt) : this.#land(component, dt));
    const at = this.#repaired.indexOf(component);
    if (!closed) {
      if (at >= 0) this.#repaired.splice(at, 1);
      this.torn.delete(component);
      return false;
    }
    if (free && at < 0) this.#slow(component, dt);
    if (free) this.#budget.end(component);
    this.bodies.write(component, dt);
    if (at >= 0) this.#stabilization.note(component);
    return true;
  }

  /**
   * What is left of a tear in a loop is no motion either: links between two ends that nearly are as far apart as they can be
   * have to go far sideways for it (measured: 0.6 m/s for 10 µm at `reference`).
   */
  #isTorn(component: Component, error: number): boolean {
    const byEdit = error > TORN && !this.#disturbed.has(component);
    if (byEdit && component.loops.length > 0) this.#mended.begin(component);
    return guards.torn(error, this.#mended.goesOn(component) ? NO_MISS : TORN);
  }

  /**
   * Whether it may crack like a whip, by its length, a loop or a joint of two axes, and nothing but forces does work on it:
   * no motor, nothing soft, nobody who drags or carries.
   */
  #isFree({ bodies, joints, rows, loops }: Component): boolean {
    if (this.#system.resisting.size > 0) return false;
    if (bodies.length < LONG && loops.length === 0 && !rows.some(this.#crosses)) return false;
    for (const k of joints)
      if (this.#ends.moves(k) || this.#bounded.any(k) || this.#rows.anySoft(k)) return false;
    return true;
  }

  readonly #crosses = (k: number): boolean => this.#rows.crosses(k);

  /** What has more energy than joints could leave it is slowed, and led on anew. */
  #slow(component: Component, dt: number): void {
    for (let round = 0; round < SLOWING_ROUNDS; round++) {
      const share = this.#budget.share(component);
      if (share === 1) return;
      this.#budget.slow(component, share);
      if (!this.#system.again(component)) return;
      this.#search.correct(component, dt, 1);
    }
  }

  /**
   * What hangs in loops goes on, once Bullet's solver is through, at those velocities nearest to what contacts made of it that
   * leave its joints whole: where only the closing after the step sees to that, a net on a ball takes three times the factors.
   */
  leadOn(component: Component, dt: number): void {
    const before = this.#led.delete(component);
    if (component.loops.length === 0 || this.#repaired.includes(component)) return;
    const swerved = this.#stabilization.swerved(component);
    if (!swerved && !before) return;
    if (swerved) this.bodies.readMomentum(component, dt);
    this.#system.firm = this.#search.taut.has(component);
    if (!this.#system.again(component)) return;
    this.#search.correct(component, dt, 1);
    if (!this.bodies.sane(component)) return;
    this.#stabilization.keep(component);
    if (swerved && !this.#leadPushed(component)) return;
    this.#stabilization.lead(component, dt);
  }

  /** Somebody else solves it in this step. */
  leave(component: Component): void {
    this.#led.delete(component);
  }

  /** What it is pushed by is no motion: that is taken back after the step. */
  #leadPushed(component: Component): boolean {
    this.bodies.readMomentum(component, 0);
    if (!this.#system.again(component) || !this.bodies.sane(component)) return false;
    this.#led.add(component);
    this.#repaired.push(component);
    return true;
  }

  /** Visits the stops and motors of joint `k`. */
  eachBound(k: number, visit: (bound: Bound) => void): void {
    this.#bounded.each(k, visit);
  }

  /** Tells which stops of joint `k` held in this step. */
  tellStops(k: number, listener: StopListener): void {
    this.#bounded.tell(k, listener);
  }

  /** Whether a body of a component is put somewhere else, since an edit had torn a joint of it. */
  leaves(component: Component, body: Body, dt: number): boolean {
    if (!this.torn.has(component)) return false;
    return component.bodies.some(
      (i) => this.bodies.bodies[i] === body && this.#tornJoints.leaves(i, dt),
    );
  }

  /** What contacts left of the last one that was settled, m or rad, and the joint that is open. */
  left = 0;

  get widest(): number {
    return this.#closing.widest;
  }

  /** What contacts did to joints in the step, and what the step itself left open, is brought together here. False: nothing but joints and forces acted. */
  settle(component: Component, dt: number): boolean {
    const disturbed = this.#led.has(component) || this.#stabilization.disturbed(component, dt);
    if (disturbed) this.#disturbed.add(component);
    else this.#disturbed.delete(component);
    const torn = this.torn.has(component);
    if (torn) this.#tornJoints.close(component, dt);
    this.#system.firm = this.#search.taut.has(component);
    this.left = 0;
    const open = this.#search.open.has(component);
    if (open || disturbed) {
      const left = this.#closing.close(component, dt, this.#mayMiss(component, dt));
      // An edit's gap is nothing to tell, nor what whips about.
      if (disturbed && !this.#mended.has(component)) this.left = left;
    }
    return disturbed || torn;
  }

  /** What closing may leave of it, m or rad: where contacts move loops, by what a step of its level may miss. */
  #mayMiss(component: Component, dt: number): number {
    if (!this.#led.has(component)) return this.#search.open.has(component) ? LEFT_OPEN : DISTURBED;
    const way = dt * this.bodies.fastestOf(component);
    return Math.min(TORN / 2, Math.max(DISTURBED, this.#simulation.bullet.settings.miss * way));
  }

  /** One that slept when the step began, and that Bullet woke in it: where it was moved its joints go along. */
  settleWoken(component: Component, dt: number): void {
    if (this.bodies.woken(component)) this.#closing.close(component, dt, DISTURBED);
  }

  /**
   * What was moved together again shall not go on moving. `tell`: where more than that had to be taken, m/s; what a hit gives a
   * knot of a net on its way, though its joints would not let it, is no tear.
   */
  takeBack(tell: (component: Component, speed: number) => void): void {
    for (const component of this.#repaired) {
      const speed = this.#stabilization.takeBack(component, this.torn.has(component));
      if (speed > 0 && !this.#led.has(component)) tell(component, speed);
    }
    for (const component of this.torn) this.#tornJoints.turnSpins(component);
  }

  /** What a body begins a step with, as it is in its arrays until the next is asked for. */
  ahead(component: Component, body: Body, dt: number): Ahead | undefined {
    this.bodies.read(component, dt);
    const { inertia, momentum } = this.#system;
    const i = component.bodies.find((each) => this.bodies.bodies[each] === body);
    return i === undefined ? undefined : { inertia, momentum, velocity: this.bodies.velocity, i };
  }

  /**
   * How a step lets bodies of a component go by what one that pulls gives them: from the factors that the step would have without
   * its pull, of rows that held in the last one. Nothing of it lasts. False: there are none that make sense.
   */
  yields(component: Component, bodies: readonly Body[], dt: number, by: Pull, to: Yields): boolean {
    const error = this.#fill(component, dt, by);
    const torn = guards.torn(error, this.#mended.has(component) ? NO_MISS : TORN);
    this.#system.firm = this.#search.taut.has(component);
    this.#search.setTargets(component, dt, torn ? 0 : 1);
    if (!this.bodies.finite || !this.#system.solveAsHeld(component)) return false;
    to.whole = !torn;
    return this.bodies.sane(component) && this.#yields.find(component, bodies, to);
  }

  /**
   * After `yields`, by what is given to its bodies since: the round ways of the step are others by that. Returns by how much
   * they go otherwise if nobody gives them anything, m/s or rad/s.
   */
  yieldsBy(component: Component, impulse: Float64Array, dt: number, to: Yields): number {
    if (!to.whole) return 0;
    this.#system.firm = this.#search.taut.has(component);
    this.#yields.give(component, to, impulse, 1);
    this.#search.correct(component, dt, 1);
    this.#yields.give(component, to, impulse, -1);
    return this.#yields.findFree(to);
  }

  // ---- between steps ------------------------------------------------------------------------------------------------

  /** Whether nothing acts on it but forces, motors, and joints that give way to nobody: what half a step of them does is known. */
  hangsFree({ joints, bodies }: Component): boolean {
    for (const pull of this.pulls)
      for (const i of bodies) if (pull.pullsAt(this.bodies.bodies[i]!)) return false;
    for (const k of joints)
      if (this.#ends.moves(k) || this.#rows.anySoft(k) || this.#bounded.stopped(k)) return false;
    return true;
  }

  /** The velocities, by body, that a component has at the end of its step; undefined: there are none that make sense. */
  atMoment(component: Component): Float64Array | undefined {
    const dt = this.bodies.stepOf(component);
    this.#fill(component, dt);
    this.#search.setTargets(component, dt, 0);
    for (const k of component.rows) this.#bounded.letStops(k);
    if (!this.bodies.finite || !this.#system.solve(component)) return undefined;
    return this.bodies.sane(component) ? this.#system.velocity : undefined;
  }

  // ---- the solution -------------------------------------------------------------------------------------------------

  /** Returns the worst error of a joint. */
  #fill(component: Component, dt: number, without?: Pull): number {
    let worst = 0;
    this.#read(component, dt);
    for (const k of component.pins) {
      worst = Math.max(worst, this.#pins.fill(k));
      this.#stiffness.stiffenPin(k, dt);
    }
    for (const k of component.rows) {
      worst = Math.max(worst, this.#rows.fill(k, dt), this.#bounded.fill(k, dt));
      if (!this.#system.isPin[k]) this.#stiffness.stiffen(k, this.#ends.geometry.two.origin, dt);
    }
    this.#drag(component, dt, without);
    return worst;
  }

  #read(component: Component, dt: number): void {
    this.bodies.read(component, dt);
    this.#system.resisting.clear();
  }

  /** What somebody pulls at. */
  #drag({ bodies }: Component, dt: number, without?: Pull): void {
    for (const pull of this.pulls)
      if (pull !== without)
        for (const i of bodies) pull.pullIn(this.bodies.bodies[i]!, this.#system, i, dt);
  }

  /** False: no solution that makes sense. */
  #find(component: Component, dt: number, repair: 0 | 1): boolean {
    const found = this.#search.find(component, dt, repair);
    // The repair of a torn joint is no pull.
    if (!found || this.#repaired.includes(component)) return found;
    for (const k of component.pins) this.#stiffness.notePin(k);
    for (const k of component.rows) if (!this.#system.isPin[k]) this.#stiffness.note(k);
    return true;
  }

  /** Joints that an edit tore apart come together in the step, but what that takes is no motion of the bodies. */
  #repair(component: Component, dt: number): boolean {
    this.#repaired.push(component);
    this.#stabilization.keep(component);
    this.#search.setTargets(component, dt, 1);
    for (const k of component.rows) this.#bounded.setRepairTargets(k, dt);
    if (!this.#find(component, dt, 1)) return false;
    this.torn.add(component);
    this.#tornJoints.note(component);
    const open = this.#search.open.has(component);
    // What the step and the next one begin with is the motion again.
    this.#search.setTargets(component, dt, 0);
    if (!this.#find(component, dt, 0)) return false;
    if (open) this.#search.open.add(component);
    return true;
  }

  /** What meets a stop within the step is thrown back there: the step takes it elsewhere than its rate after it would. */
  #land(component: Component, dt: number): boolean {
    if (!this.#bounded.setLandingTargets(component)) return true;
    this.#repaired.push(component);
    this.#stabilization.keep(component);
    return this.#find(component, dt, 1);
  }
}
