import { doublesOf, pack } from '../../base/packed.js';
import type { Body } from '../../dynamics/body.js';
import type { Joint } from '../../dynamics/joint.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { APART, setSolverDistanceAt } from '../../engine/manifold-points.js';
import { Effect, type Cause, type Numbered } from '../effect/effect.js';
import type { Effects } from '../effect/effects.js';
import { stops } from './effects.js';
import { isBounded, type Bound } from './bounded-rows.js';
import { ComponentSolve, type Ahead, type KeptComponent, type Pull } from './component-solve.js';
import { Forest, type Component, type Edge } from '../../solver/joints/forest.js';
import type { Way } from './joint-ends.js';
import type { JointedBodies } from './jointed-bodies.js';
import { GAPING, reportGap } from './joint-reports.js';
import { JointRows } from './joint-rows.js';
import { isPin } from './point-constraints.js';
import { SleepingRows } from './sleeping-rows.js';
import { MomentVelocities } from './moment-velocities.js';
import { StepTurns } from './step-turns.js';
import type { Yields } from './yielding-bodies.js';

/** Bodies that joints hold together, and those joints. */
export interface Jointed {
  readonly bodies: readonly Body[];
  readonly joints: readonly Joint[];
}

/** For a snapshot: bodies and joints by their ids. */
interface KeptJoints {
  steps: [id: number, step: number, seconds: number][];
  alone: number[];
  loads: [id: number, load: string][];
  pulls: [id: number, pull: string][];
  /** Undefined: they are numbered anew in the next step, which asks nothing of the last one. */
  joints?: [id: number, kept: string][];
  /** By their first joints. */
  components?: [id: number, kept: KeptComponent][];
}

/**
 * Solves all joints directly, before each step of Bullet: the velocities it hands over carry the bodies, along their
 * round ways, to where every joint is whole (SHAKE, with the direct solution of its rows in place of iterations).
 * Bullet's own constraints are told to aim at those velocities: they stay on for what contacts do in the step.
 */
export class JointSolve extends Effect {
  readonly #simulation: Simulation;
  readonly #effects: Effects;
  readonly #forest = new Forest();
  readonly #solver: ComponentSolve;
  /** Of carried bodies. */
  readonly #ways = new Map<Body, Way>();
  /** Bullet's own rows. */
  readonly #sleepingRows: SleepingRows;
  readonly #turns: StepTurns;
  readonly #moments: MomentVelocities;
  #joints: (Joint | undefined)[] = [];
  #edges: readonly Edge[] = [];
  /** Where each of them stands there. */
  readonly #numbers = new Map<Joint, number>();
  /** Those of this step. */
  readonly #solved = new Set<Component>();
  /** Those of them that are solved together with what touches them. */
  readonly #inTouch = new Set<Component>();
  /** Those that slept when this step began. */
  readonly #asleep: Component[] = [];
  readonly #alone = new Set<Body>();
  /** Bodies that something else than a joint holds, by what ties them. */
  readonly #ties = new Map<Cause, Body>();
  readonly #componentOf = new Map<Body, Component>();
  readonly #jointed = new Map<Component, Jointed>();
  /** How wide joints gaped that were told of, m or rad. */
  readonly #gaps = new WeakMap<Joint, number>();
  /** Of one joint after the other, for those who ask where it stands. */
  readonly rows: JointRows;
  #stale = true;
  #rebuilt = 0;

  constructor(simulation: Simulation, effects: Effects) {
    super();
    this.#effects = effects;
    this.#simulation = simulation;
    this.rows = this.newRows();
    this.#solver = new ComponentSolve(simulation);
    this.#turns = new StepTurns(simulation);
    this.#moments = new MomentVelocities(simulation, this.#solver);
    this.#sleepingRows = new SleepingRows(this.#bodies, this.#solver.targets);
  }

  /** For effects whose code comes without that of joints: they need it only where there is one. */
  newRows(): JointRows {
    return new JointRows(this.#simulation);
  }

  get #bodies(): JointedBodies {
    return this.#solver.bodies;
  }

  /** What pulls at bodies by more than a force. */
  get pulls(): Set<Pull> {
    return this.#solver.pulls;
  }

  /** A joint came, or holds otherwise than before; its stops or motors are others, or who of its bodies moves. */
  override need(joint: Joint, reason: string): void {
    this.#stale = true;
    super.need(joint, reason);
  }

  /** What ties a body is no joint: it pulls in the solve of this body and of all that hangs together with it. */
  tie(node: Cause, body: Body, reason: string): void {
    if (this.#ties.get(node) === body) return;
    this.#ties.set(node, body);
    this.#stale = true;
    super.need(node, reason);
  }

  /** What a step of `dt` seconds finds a tied body with; undefined: it does not move, or sleeps. */
  ahead(body: Body, dt: number): Ahead | undefined {
    if (this.#stale) this.#rebuild();
    const component = this.#componentOf.get(body);
    if (!component || this.#bodies.asleep(component)) return undefined;
    return this.#solver.ahead(component, body, dt);
  }

  /** What a tied body hangs together with now, by joints alone: the same for all of it, until any joint comes or goes. */
  togetherWith(body: Body): Component | undefined {
    if (this.#stale) this.#rebuild();
    return this.#componentOf.get(body);
  }

  /** Another number whenever it may be other bodies that hang together. */
  get numbering(): number {
    if (this.#stale) this.#rebuild();
    return this.#rebuilt;
  }

  /** How a step lets bodies go that hang together, by what `by` gives them. False: their joints do not say. */
  yields(bodies: readonly Body[], dt: number, by: Pull, to: Yields): boolean {
    const component = this.togetherWith(bodies[0]!);
    if (!this.on || !component || this.#bodies.asleep(component)) return false;
    for (const body of this.#ways.keys()) this.#takeEnds(body);
    return this.#solver.yields(component, bodies, dt, by, to);
  }

  /** After that, in the same step: the same by what bodies are given since. Returns by how much that is another, m/s or rad/s. */
  yieldsBy(body: Body, impulse: Float64Array, dt: number, to: Yields): number {
    return this.#solver.yieldsBy(this.togetherWith(body)!, impulse, dt, to);
  }

  override release(node: Cause): void {
    if (!this.isNeededBy(node)) return;
    this.#ties.delete(node);
    this.#letsGo(node as Joint);
    this.#stale = true;
    super.release(node);
    const k = this.#numbers.get(node as Joint);
    if (k === undefined) return;
    this.#joints[k] = undefined;
    this.#numbers.delete(node as Joint);
  }

  /** What a joint did is not to be known when it comes again. Bodies lose their joints before they go. */
  override unmade(node: Cause): void {
    this.relaunch(node);
    this.release(node);
  }

  /** An immovable body was put elsewhere: its ends of joints go along. */
  carried(body: Body): void {
    if (!this.#stale) this.#takeEnds(body);
  }

  /** The step that begins takes an immovable body along a way. */
  carry(body: Body, way: Way): void {
    this.#ways.set(body, way);
  }

  /** It is carried no more. */
  stands(body: Body): void {
    if (this.#ways.delete(body)) this.carried(body);
  }

  #takeEnds(body: Body): void {
    for (const joint of body.joints) {
      const k = this.#numbers.get(joint);
      if (k === undefined) continue;
      const one = this.#wayOf(joint.body1);
      const two = this.#wayOf(joint.body2);
      this.#solver.takeEnds(k, joint, one || two ? { one, two } : undefined);
    }
  }

  #wayOf(body: Body | undefined): Way | undefined {
    return body && this.#ways.get(body);
  }

  /** Seconds of a body's last step, to the middle of which its velocity belongs; 0: to this moment. */
  lastStep(body: Body): number {
    return this.#bodies.lastStep(body);
  }

  /** Visits those that it ever moved. */
  eachMoved(visit: (body: Body) => void): void {
    this.#bodies.eachMoved(visit);
  }

  // ---- going back -----------------------------------------------------------------------------------------------------

  override reset(): void {
    this.#bodies.forgetSteps();
    this.#alone.clear();
    this.#ways.clear();
    this.#joints = [];
    this.#numbers.clear();
    this.#stale = true;
  }

  override save(): KeptJoints {
    const solver = this.#solver;
    const of = (k: number): number => this.#joints[k]!.id;
    const known = this.#joints.map((joint, k) => (joint ? k : -1)).filter((k) => k >= 0);
    const kept: KeptJoints = {
      steps: this.#bodies.keepSteps(),
      alone: [...this.#alone].map(({ id }) => id),
      loads: this.#bodies.keepLoads().map(([id, load]) => [id, pack(load)]),
      pulls: known.map((k) => [of(k), pack(solver.pullsOf(k))]),
    };
    if (this.#stale) return kept;
    kept.joints = known.map((k) => [of(k), pack(solver.keepJoint(k))]);
    kept.components = [];
    for (const component of this.#forest.components) {
      const state = component.joints.length > 0 && solver.keepComponent(component);
      if (state) kept.components.push([of(component.joints[0]!), state]);
    }
    return kept;
  }

  override load(kept: KeptJoints, nodes: Numbered): void {
    for (const [id, step, seconds] of kept.steps) {
      const body = nodes.body(id);
      if (body) this.#bodies.goOn(body, step, seconds);
    }
    for (const id of kept.alone) {
      const body = nodes.body(id);
      if (body) this.#alone.add(body);
    }
    if (!this.active) return;
    this.#rebuild();
    for (const [id, load] of kept.loads) {
      const body = nodes.body(id);
      if (body) this.#bodies.setLoad(body, doublesOf(load));
    }
    const numberOf = (id: number): number => this.#numbers.get(nodes.joint(id)!) ?? -1;
    for (const [id, pulls] of kept.pulls)
      if (numberOf(id) >= 0) this.#solver.setPulls(numberOf(id), doublesOf(pulls));
    // It was to be built anew, and nothing else lasts.
    this.#stale = !kept.joints;
    for (const [id, state] of kept.joints ?? [])
      if (numberOf(id) >= 0) this.#solver.loadJoint(numberOf(id), doublesOf(state));
    const components = new Map(this.#forest.components.map((each) => [each.joints[0]!, each]));
    for (const [id, state] of kept.components ?? []) {
      const component = components.get(numberOf(id));
      if (component) this.#solver.loadComponent(component, state);
    }
  }

  /** Where steps are taken on another thread: what is heard from there. */
  shownOf: JointSolve['velocityOf'] | undefined;

  /** The velocity of a body at this moment, from `at` on, where it has another; undefined: it has that. */
  velocityOf(body: Body): { velocities: Float64Array; at: number } | undefined {
    if (this.shownOf) return this.shownOf(body);
    const component = this.#free(body);
    return component && this.#moments.of(component, body);
  }

  /** What a body hangs together with gets another load, or is struck: at this moment, and not in the middle of a step. */
  loadChanges(body: Body): void {
    const component = this.#free(body);
    if (component) this.#moments.settle(component);
  }

  /** Its bodies may be others by now: those count that it held in the last step. */
  #letsGo(joint: Joint): void {
    const edge = this.#edges[this.#numbers.get(joint) ?? -1];
    const body = edge && this.#bodies.bodies[Math.max(edge.a, edge.b)];
    if (body) this.loadChanges(body);
  }

  /** What hangs together with a body, whole, where nothing but joints and forces acted in the last step. */
  #free(body: Body): Component | undefined {
    const component = this.#alone.has(body) ? this.#componentOf.get(body) : undefined;
    if (!component) return undefined;
    for (const k of component.joints) if (!this.#joints[k]) return undefined;
    return component;
  }

  /** Its velocity is given anew. */
  relaunch(body: Cause): void {
    this.#bodies.relaunch(body as Body);
  }

  /** Whether nothing but joints and forces acted, in the last step, on a body and what it hangs together with. */
  alone(body: Body): boolean {
    return this.active && this.#alone.has(body);
  }

  /** What hangs together with a body, where this step has found its motion without contacts. */
  solvedWith(body: Body): Jointed | undefined {
    const component = this.#componentOf.get(body);
    if (!component || !this.#solved.has(component)) return undefined;
    let jointed = this.#jointed.get(component);
    if (!jointed) {
      const { bodies } = this.#bodies;
      jointed = {
        bodies: Array.from(component.bodies, (i) => bodies[i]!),
        joints: Array.from(component.joints, (k) => this.#joints[k]!),
      };
      this.#jointed.set(component, jointed);
    }
    return jointed;
  }

  /** Visits the stops and motors of a joint as this step has found them. */
  eachBound(joint: Joint, visit: (bound: Bound) => void): void {
    if (isBounded(joint)) this.#solver.eachBound(this.#numbers.get(joint) ?? -1, visit);
  }

  /** FALSE leaves joints to Bullet's own iterations: for comparing the two. */
  on = true;

  readonly #touched = (body: Body): boolean => this.lastStep(body) > 0 && !this.#alone.has(body);

  /** What joints hold turns little in each part. */
  override parts(dt: number): number {
    if (this.#stale) this.#rebuild();
    return this.#turns.parts(dt, this.#touched);
  }

  override beforeStep(dt: number): void {
    if (this.#stale) this.#rebuild();
    for (const body of this.#ways.keys()) this.#takeEnds(body);
    this.#solver.begin();
    this.#solved.clear();
    this.#inTouch.clear();
    this.#asleep.length = 0;
    for (const component of this.#forest.components)
      if (this.on && !this.#bodies.asleep(component)) this.#solve(component, dt);
      else {
        this.#sleepingRows.hold(component);
        if (this.on) this.#asleep.push(component);
      }
  }

  /** This step solves a joint together with what touches its bodies: Bullet's own rows are not to be solved besides. */
  solvedInTouch({ body1, body2 }: Joint): void {
    const component = this.#componentOf.get(body1?.movable ? body1 : body2!);
    if (!component || this.#inTouch.has(component)) return;
    this.#inTouch.add(component);
    this.#sleepingRows.letGo(component);
  }

  override solved(dt: number): void {
    for (const component of this.#solved)
      if (this.#inTouch.has(component)) this.#solver.leave(component);
      else this.#solver.leadOn(component, dt);
  }

  override settle(dt: number): void {
    for (const body of this.#ways.keys()) this.#takeEnds(body);
    this.#alone.clear();
    for (const component of this.#solved) {
      if (!this.#solver.settle(component, dt))
        for (const i of component.bodies) this.#alone.add(this.#bodies.bodies[i]!);
      if (this.#solver.left > GAPING) this.#tellGap(this.#joints[this.#solver.widest]!, dt);
    }
    for (const component of this.#asleep) this.#solver.settleWoken(component, dt);
  }

  override afterStep(): void {
    this.#solver.takeBack(this.#tellThrown);
    for (const component of this.#solver.torn) this.#sleepingRows.reset(component);
  }

  readonly #tellThrown = (component: Component, speed: number): void => {
    const joint = this.#joints[component.joints[0]!]!;
    joint.report({
      code: 'joint-repair',
      severity: 'info',
      value: speed,
      used: 'the speeds from before',
      message: `${joint.label}, or a joint that it hangs together with, was torn so far apart that putting it together would throw its bodies away; they keep the speeds that they had`,
    });
  };

  /** Again where it is twice as wide. */
  #tellGap(joint: Joint, dt: number): void {
    const { left } = this.#solver;
    if (left < 2 * (this.#gaps.get(joint) ?? 0)) return;
    this.#gaps.set(joint, left);
    reportGap(joint, left, dt);
  }

  #solve(component: Component, dt: number): void {
    if (!this.#solver.solve(component, dt)) {
      this.#leaveToBullet(component);
      return;
    }
    this.#solved.add(component);
    this.#sleepingRows.solved(component, dt);
    if (this.#solver.torn.has(component)) this.#sleepingRows.releaseStops(component);
    for (const k of component.rows) this.#solver.tellStops(k, this.#effects.get(stops));
  }

  /** For this step: Bullet's own rows and velocities stand. */
  #leaveToBullet(component: Component): void {
    this.#sleepingRows.reset(component);
    // Who brought numbers that are none is told so by another.
    if (!this.#bodies.finite) return;
    const joint = this.#joints[component.joints[0]!];
    joint?.report({
      code: 'joint-solve',
      severity: 'warning',
      used: "Bullet's iterations",
      message: `${joint.label} and the joints it hangs together with have no direct solution; they are held less well`,
    });
  }

  /** Whether some of Bullet's rows are let go: the first touch finds them on. */
  override seesContacts(): boolean {
    return this.#sleepingRows.waits || this.#solver.torn.size > 0;
  }

  /** What is about to be put elsewhere touches nothing here. */
  override contact(point: number, a: number, b: number): boolean {
    if (this.#leaves(a) || this.#leaves(b)) {
      setSolverDistanceAt(this.#simulation.engine.ammo, point, APART);
      return false;
    }
    this.#sleepingRows.touch(a);
    this.#sleepingRows.touch(b);
    return true;
  }

  #leaves(pointer: number): boolean {
    const body = this.#solver.torn.size > 0 && this.#simulation.bodyAt(pointer);
    const component = body && this.#componentOf.get(body);
    return component ? this.#solver.leaves(component, body, this.#simulation.partOfStep) : false;
  }

  #rebuild(): void {
    this.#stale = false;
    this.#rebuilt++;
    // In the order of the scene, whoever came first.
    const joints = ([...this.causes] as Joint[])
      .filter((cause) => !this.#ties.has(cause))
      .sort((a, b) => a.id - b.id);
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
    for (const body of [...this.#ties.values()].sort((a, b) => a.id - b.id)) number(body);
    this.#edges = edges;
    this.#forest.build(numbers.size, edges);
    this.#turns.take([...numbers.keys()]);
    this.#solver.take([...numbers.keys()], joints, this.#joints, edges, this.#forest);
    this.#moments.take([...numbers.keys()], joints, edges, this.#forest);
    this.#sleepingRows.take(joints, this.#forest);
    this.#componentOf.clear();
    this.#jointed.clear();
    const bodies = [...numbers.keys()];
    for (const component of this.#forest.components)
      for (const i of component.bodies) this.#componentOf.set(bodies[i]!, component);
    this.#joints = joints;
    this.#numbers.clear();
    joints.forEach((joint, k) => this.#numbers.set(joint, k));
  }
}
