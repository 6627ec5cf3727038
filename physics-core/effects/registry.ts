import type { ContactProcessor } from '../engine/contact-hook.js';
import type { PhysicsNode } from '../nodes/node.js';
import type { World } from '../world/world.js';
import { AuthoredForces } from './flight/forces.js';
import { AxisDamping } from './flight/axis-damping.js';
import { Carrying } from './drag/carrying.js';
import { ContinuousCollision } from './hits/continuous-collision.js';
import { ContactReader } from './contacts/contact-reader.js';
import { FrameCosts } from './costs/frame-costs.js';
import { GivenContacts } from './contacts/given-contacts.js';
import { Dragging } from './drag/dragging.js';
import { ImpactPropagation } from './hits/impact-propagation.js';
import { ContactSurface } from './contacts/contact-surface.js';
import { Debugging } from './debug/debugging.js';
import { JointSolve } from './joints/joint-solve.js';
import type { Effect } from './effect.js';
import { Flight } from './flight/flight.js';
import { Gyroscopic } from './flight/gyroscopic.js';
import { MeshShapes } from './contacts/mesh-shapes.js';
import { JointRows } from './joints/joint-rows.js';
import { Motors } from './joints/motors.js';
import { PairFilter } from './contacts/pair-filter.js';
import { Resting } from './rest/resting.js';
import { Stops } from './joints/stops.js';
import { Suspension } from './joints/suspension.js';
import { UserTiming } from './costs/user-timing.js';

/** What `world.effects` shows. */
export interface EffectReport {
  name: string;
  active: boolean;
  /** Which element switched it on, and by what. */
  because: { element: unknown; reason: string } | null;
  /** Milliseconds per step, a running mean. */
  ms: number;
}

/** The effects of one world. Those without a cause are never called. */
export class EffectRegistry {
  readonly forces: AuthoredForces;
  readonly damping: AxisDamping;
  readonly flight: Flight;
  readonly gyroscopic: Gyroscopic;
  /** Shared by all that work on joints, one joint at a time. */
  readonly rows: JointRows;
  readonly suspension: Suspension;
  readonly dragging: Dragging;
  readonly motors: Motors;
  readonly carrying: Carrying;
  readonly given: GivenContacts;
  readonly surface: ContactSurface;
  readonly chains: ImpactPropagation;
  readonly continuous: ContinuousCollision;
  readonly filter: PairFilter;
  readonly contacts: ContactReader;
  readonly stops: Stops;
  readonly joints: JointSolve;
  readonly meshes = new MeshShapes();
  readonly resting: Resting;
  readonly debugging: Debugging;
  readonly costs = new FrameCosts();
  readonly timing: UserTiming;
  readonly all: readonly Effect[];

  constructor(world: World) {
    this.forces = new AuthoredForces(world);
    this.damping = new AxisDamping(world);
    this.flight = new Flight(world);
    this.gyroscopic = new Gyroscopic(world);
    this.rows = new JointRows(world);
    this.suspension = new Suspension(world);
    this.dragging = new Dragging(world);
    this.motors = new Motors(world);
    this.given = new GivenContacts(world);
    this.surface = new ContactSurface(world);
    this.chains = new ImpactPropagation(world);
    this.continuous = new ContinuousCollision(world);
    this.filter = new PairFilter(world);
    this.carrying = new Carrying(world);
    this.contacts = new ContactReader(world);
    this.stops = new Stops(world);
    this.joints = new JointSolve(world);
    this.resting = new Resting(world);
    this.debugging = new Debugging(world);
    this.timing = new UserTiming(world);
    this.all = [
      this.forces,
      this.damping,
      this.flight,
      this.gyroscopic,
      this.suspension,
      this.dragging,
      this.motors,
      this.stops,
      this.chains,
      this.continuous,
      this.joints,
      this.surface,
      this.given,
      this.filter,
      this.carrying,
      this.contacts,
      this.meshes,
      this.resting,
      this.debugging,
      this.costs,
      this.timing,
    ];
  }

  beforeStep(dt: number): void {
    for (const effect of this.all) run(effect, 'beforeStep', dt);
  }

  settle(dt: number): void {
    for (const effect of this.all) run(effect, 'settle', dt);
  }

  afterStep(dt: number): void {
    for (const effect of this.all) run(effect, 'afterStep', dt);
    for (const effect of this.all) if (effect.active) effect.noteCost();
  }

  /** What sees every contact point, if anything does: first what takes contacts back, last what writes into them. */
  get processor(): ContactProcessor | null {
    let first: ContactProcessor | null = this.surface.active ? this.surface : null;
    const { sleepingRows } = this.joints;
    if (this.joints.active && sleepingRows.waits) {
      sleepingRows.next = first;
      first = sleepingRows;
    }
    if (!this.filter.active) return first;
    this.filter.next = first;
    return this.filter;
  }

  /** For a contact point that is none of Bullet's. */
  process(point: number, a: number, b: number): void {
    const { filter, surface } = this;
    filter.next = surface;
    (filter.active ? filter : surface).process(point, a, b);
  }

  dropAll(node: PhysicsNode): void {
    for (const effect of this.all) effect.drop(node);
  }

  report(): EffectReport[] {
    return this.all.map((effect) => ({
      name: effect.name,
      active: effect.active,
      because: effect.because
        ? { element: effect.because.node.host, reason: effect.because.reason }
        : null,
      ms: effect.active ? effect.ms : 0,
    }));
  }
}

function run(effect: Effect, phase: 'beforeStep' | 'settle' | 'afterStep', dt: number): void {
  if (!effect.active || !effect[phase]) return;
  const start = performance.now();
  effect[phase](dt);
  effect.spent += performance.now() - start;
}
