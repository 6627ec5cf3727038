import type { Body } from '../../dynamics/body.js';
import type { Joint } from '../../dynamics/joint.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { setSolverDistanceAt, solverDistanceAt } from '../../engine/manifold-points.js';
import { contactShapes } from '../manifolds/effects.js';
import { Effect, type Cause, type Numbered } from '../effect/effect.js';
import type { Effects } from '../effect/effects.js';
import { dot3 } from '../../base/flat-math.js';
import { BULLETS_TURN } from '../../engine/turns.js';
import { fullTurns } from '../flight/full-turns.js';
import { jointSolve } from '../joints/effects.js';
import { gyroscopic } from '../flight/gyroscopic.js';
import { resting } from '../rest/resting.js';
import { ropes } from '../soft/effects.js';
import { BounceEnergy } from '../../solver/energy/bounce-energy.js';
import { BoundRows } from '../../solver/rows/bound-rows.js';
import { ConeContacts } from '../../solver/rows/cone-contacts.js';
import { CoupledJoints } from './coupled-joints.js';
import { Grips } from './grips.js';
import { JointedEnergy } from '../../solver/energy/jointed-energy.js';
import { Newton } from '../../solver/methods/newton.js';
import type { Part } from '../../solver/part.js';
import { PartReader } from './part-reader.js';
import { ContactPort } from './read-contact.js';
import { RollingResistance, type KeptRolling } from './rolling-resistance.js';
import { Savings } from '../../solver/methods/savings.js';
import { TouchingBodies } from './touching-bodies.js';
import { CurvedPaths } from './curved-paths.js';
import { SIZE } from '../../solver/matrix/block-cholesky.js';
import { StandingStart } from '../../solver/methods/standing-start.js';
import { Sweeps } from '../../solver/methods/sweeps.js';
import { TouchingParts } from './touching-parts.js';
import { TurningCorners } from './turning-corners.js';
import { Ways, type Way } from './ways.js';
import { MANY, MOST_TURN_ROLLING, PAUSE, ROUGH } from '../../solver/tolerances.js';

/** Farther than Bullet's solver looks, metres: what is solved here is not there for it. */
const ASIDE = 1e24;

/**
 * What is turned farther than this in a step where overlaps are taken out takes its spin along, radians. Below, its momentum
 * stands: that is nearer to how a top on its tip goes round (measured).
 */
const TURNED = 0.1;

/** For a snapshot: bodies and joints by their ids. */
interface KeptSolve {
  cause: number;
  /** Whether boxes have points of each step. */
  points: boolean;
  direct: number[];
  left: number[];
  heaps: number[];
  failed: [id: number, step: number][];
  again: number;
  savings: ReturnType<Savings['save']>;
  joints: ReturnType<CoupledJoints['save']>;
  rolling: KeptRolling;
  pulls: ReturnType<Grips['pulls']['save']>;
  balls: number[];
}

interface Solver {
  /** False: it finds no end. */
  solve(part: Part): boolean;
  /** By how much its bodies are moved apart goes to `change` of the bodies. False: nothing overlaps. */
  pushApart(): boolean;
}

/**
 * Solves what is in touch directly, joints included: between Bullet's contact search and its solver it finds the
 * velocities at which every contact holds, slides or lets go as Coulomb's law says, and puts them in the place of those
 * that Bullet's iterations lead to.
 */
export class ContactSolve extends Effect {
  readonly #simulation: Simulation;
  readonly #effects: Effects;
  readonly #contacts = new ConeContacts();
  readonly #rows = new BoundRows();
  readonly #bodies: TouchingBodies;
  readonly #parts: TouchingParts;
  readonly #reader: PartReader;
  readonly #ways: Ways;
  readonly #solvers: { readonly matrix: Newton; readonly sweeps: Sweeps };
  readonly #bounces: BounceEnergy;
  readonly #jointed: JointedEnergy;
  readonly #rolling: RollingResistance;
  readonly #savings = new Savings();
  readonly #standing: StandingStart;
  readonly #port: ContactPort;
  readonly #joints: CoupledJoints;
  readonly #curvedPaths: CurvedPaths;
  readonly #corners: TurningCorners;
  readonly #grips: Grips;
  /** Those that were solved directly. */
  readonly #solved: Part[] = [];
  /** Pointers of the bodies of parts that are solved directly. */
  readonly #direct = new Set<number>();
  /** And of those of the others: a step has not the effort for what moves. */
  readonly #left = new Set<number>();
  /** And of those of large heaps that matrices are too dear for in each step, and that hang on no joints. */
  readonly #heaps = new Set<number>();
  /** The step from which on a part may be tried again, by pointer of its first body. */
  readonly #failed = new Map<number, number>();
  /** The step from which on contacts are looked at again. */
  #again = 0;
  /** What Bullet is to find again, by contact. */
  readonly #distances: number[] = [];
  /** The body that is named as its cause. */
  #cause: Body | undefined;
  /** The cause of what it needs itself. */
  readonly #own: Cause;

  constructor(simulation: Simulation, effects: Effects) {
    super();
    this.#simulation = simulation;
    this.#effects = effects;
    const host = (): unknown => this.#cause?.host;
    this.#own = {
      get host() {
        return host();
      },
    };
    const { ammo } = simulation.engine;
    this.#bodies = new TouchingBodies(ammo);
    this.#ways = new Ways(simulation, this.#bodies);
    this.#rolling = new RollingResistance(simulation, this.#contacts, this.#rows, this.#bodies);
    this.#solvers = {
      matrix: new Newton(this.#contacts, this.#rows, this.#bodies),
      sweeps: new Sweeps(this.#contacts, this.#rows, this.#bodies),
    };
    this.#bounces = new BounceEnergy(this.#contacts, this.#rows, this.#bodies);
    this.#jointed = new JointedEnergy(this.#contacts, this.#rows, this.#bodies);
    this.#standing = new StandingStart(this.#contacts, this.#bodies);
    this.#port = new ContactPort(ammo, this.#bodies, this.#contacts);
    this.#joints = new CoupledJoints(this.#rows, this.#bodies);
    this.#curvedPaths = new CurvedPaths(
      ammo,
      this.#contacts,
      this.#rows,
      this.#bodies,
      this.#joints,
    );
    this.#parts = new TouchingParts(simulation, effects, this.#bodies);
    this.#corners = new TurningCorners(simulation, effects, this.#bodies, this.#contacts);
    this.#grips = new Grips(simulation, effects, this.#bodies, this.#contacts);
    this.#reader = new PartReader(
      simulation,
      effects,
      this.#bodies,
      this.#port,
      this.#joints,
      this.#corners,
    );
  }

  // ---- who needs it -------------------------------------------------------------------------------------------------

  /** Something is in touch in this step. */
  touch(body: Body): void {
    if (this.#cause) return;
    this.#cause = body;
    this.need(body, 'touches another');
    this.#needPoints(true);
  }

  /** Boxes have points of this very step for what is solved here, and only for that. */
  #needPoints(needed: boolean): void {
    const shapes = this.#effects.get(contactShapes);
    if ((shapes.solver === this) === needed) return;
    shapes.solver = needed ? this : undefined;
    if (needed) shapes.need(this.#own, 'boxes in touch');
    else shapes.release(this.#own);
  }

  /** Whether the last step solved directly what touches one of these bodies, by pointer. */
  solves(a: number, b: number): boolean {
    return this.#direct.has(a) || this.#direct.has(b);
  }

  /** Whether it left it to Bullet, since a step of this level has not the effort for it. */
  leaves(a: number, b: number): boolean {
    return this.#left.has(a) || this.#left.has(b);
  }

  override release(node: Cause): void {
    super.release(node);
    if (node !== this.#cause) return;
    this.#cause = undefined;
    this.#direct.clear();
    this.#left.clear();
    this.#heaps.clear();
    this.#rolling.forget();
    this.#corners.begin();
    this.#needPoints(false);
  }

  override unmade(node: Cause): void {
    this.#joints.forget(node as Joint);
    this.#rolling.leave((node as Body).pointer);
    this.#grips.forget(node as Body);
    this.#failed.clear();
    this.release(node);
  }

  // ---- going back -----------------------------------------------------------------------------------------------------

  override reset(): void {
    this.#failed.clear();
    this.#direct.clear();
    this.#left.clear();
    this.#heaps.clear();
    this.#savings.forget();
    this.#rolling.forget();
    this.#joints.forgetAll();
    this.#grips.pulls.forgetAll();
    this.#again = 0;
    this.#letGo();
  }

  override save(): KeptSolve | undefined {
    if (!this.#cause) return undefined;
    const idOf = (pointer: number): number => this.#simulation.bodyAt(pointer)?.id ?? 0;
    const idsOf = (pointers: ReadonlySet<number>): number[] => [...pointers].map(idOf);
    return {
      cause: this.#cause.id,
      points: this.#effects.get(contactShapes).solver === this,
      direct: idsOf(this.#direct),
      left: idsOf(this.#left),
      heaps: idsOf(this.#heaps),
      failed: [...this.#failed].map(([pointer, step]) => [idOf(pointer), step]),
      again: this.#again,
      savings: this.#savings.save(),
      joints: this.#joints.save(),
      rolling: this.#rolling.save(),
      pulls: this.#grips.pulls.save(),
      balls: this.#corners.save(),
    };
  }

  override load(kept: KeptSolve, nodes: Numbered): void {
    const cause = nodes.body(kept.cause);
    if (!cause) return;
    this.touch(cause);
    this.#needPoints(kept.points);
    const fill = (pointers: Set<number>, ids: readonly number[]): void => {
      for (const id of ids) pointers.add(nodes.body(id)?.pointer ?? 0);
    };
    fill(this.#direct, kept.direct);
    fill(this.#left, kept.left);
    fill(this.#heaps, kept.heaps);
    for (const [id, step] of kept.failed) this.#failed.set(nodes.body(id)?.pointer ?? 0, step);
    this.#again = kept.again;
    this.#savings.load(kept.savings);
    this.#joints.load(kept.joints, nodes);
    this.#rolling.load(kept.rolling, nodes);
    this.#grips.pulls.load(kept.pulls, nodes);
    this.#corners.load(kept.balls, nodes);
    const rest = this.#effects.caused(resting);
    if (rest) rest.heaps = this.#heaps;
  }

  #letGo(): void {
    if (this.#cause) this.release(this.#cause);
  }

  // ---- a step -------------------------------------------------------------------------------------------------------

  /** What rolls elsewhere than about its centre of mass turns little in each part. */
  override parts(dt: number): number {
    return this.#corners.turnRolling(dt) / MOST_TURN_ROLLING;
  }

  override solve(dt: number): void {
    this.#solved.length = 0;
    this.#corners.begin();
    // Iterations were asked for since.
    if (!this.#simulation.bullet.settings.direct) return this.#letGo();
    if (this.#simulation.stepsTaken < this.#again) return;
    this.#parts.gather();
    if (this.#parts.manifolds.length === 0) {
      // What sleeps is to wake with the points that it fell asleep with.
      if (!this.#simulation.bullet.anyTouching) this.#letGo();
      return;
    }
    const worth = this.#ways.choose(this.#parts);
    this.#noteDirect();
    this.#needPoints(worth);
    if (!worth) {
      this.#again = this.#simulation.stepsTaken + PAUSE;
      return;
    }
    this.#contacts.count = this.#rows.count = 0;
    const { miss } = this.#simulation.bullet.settings;
    this.#solvers.matrix.loose = miss;
    this.#reader.begin(dt);
    this.#rolling.begin();
    const { parts, ways } = this.#ways;
    for (let i = 0; i < parts.length; i++) {
      const part = parts[i]!;
      part.inHeap = this.#rolling.isHeap(part);
      part.rough = miss > ROUGH && (part.inHeap || part.bodies.length > MANY);
      if (!this.#reader.read(part, ways[i] !== 'matrix')) continue;
      this.#rolling.add(part);
      this.#try(part, ways[i]!);
    }
  }

  /** Those that sleep stay what they were. */
  #noteDirect(): void {
    this.#left.clear();
    const bounded = this.#simulation.bullet.settings.effort < Infinity;
    for (let i = 0; i < this.#parts.count; i++) {
      const { bodies, manifolds, direct } = this.#parts.at(i);
      const left = bounded && !direct && manifolds.length > 0;
      for (const body of bodies) {
        this.#note(this.#bodies.pointers[body]!, direct);
        if (left) this.#left.add(this.#bodies.pointers[body]!);
      }
    }
    const rest = this.#effects.caused(resting);
    if (rest) rest.heaps = this.#heaps;
  }

  #note(pointer: number, isDirect: boolean): void {
    if (!isDirect) this.#direct.delete(pointer);
    else if (!this.#direct.has(pointer)) this.#direct.add(pointer);
    if (this.#heaps.size > 0) this.#heaps.delete(pointer);
  }

  /** What is too dear is left to Bullet for some steps. */
  #try(part: Part, way: Way): void {
    const { stepsTaken } = this.#simulation;
    const pointer = this.#bodies.pointers[part.bodies[0]!]!;
    if (this.#failed.get(pointer)! > stepsTaken) return;
    part.stands = !part.jointed && this.#stands(part);
    if (way === 'either' && !part.jointed)
      for (const body of part.bodies) this.#heaps.add(this.#bodies.pointers[body]!);
    if (way === 'either' && this.#settle(part)) return;
    // Joints are stiff: sweeps would leave them open.
    if (way !== 'matrix' && part.jointed) return;
    this.#solvers.sweeps.slow = way === 'either';
    let solver: Solver | undefined;
    const find = (): boolean => (solver = this.#find(part, way)) !== undefined;
    const findRoughly = (): boolean => (solver = this.#findRoughly(part)) !== undefined;
    this.#jointed.begin(part);
    if (this.#bounces.solve(part, find, findRoughly)) {
      this.#jointed.limit(part);
      this.#failed.delete(pointer);
      this.#take(part, solver!);
    } else this.#failed.set(pointer, stepsTaken + PAUSE);
  }

  #stands(part: Part): boolean {
    const { partOfStep, bullet } = this.#simulation;
    return this.#standing.begin(part, partOfStep, bullet.settings.linearSlop);
  }

  #find(part: Part, way: Way): Solver | undefined {
    const { matrix, sweeps } = this.#solvers;
    if (way !== 'matrix') return sweeps.solve(part) ? sweeps : undefined;
    if (this.#curvedPaths.solve(part, this.#simulation.partOfStep, matrix)) return matrix;
    return matrix.ranAway ? this.#findRoughly(part) : undefined;
  }

  /** Where a matrix runs away contacts are gone over one at a time, joints too, from no impulse on: that never runs away. */
  #findRoughly(part: Part): Solver | undefined {
    const { sweeps } = this.#solvers;
    this.#contacts.forget(part.contacts);
    this.#rows.forget(part.rows);
    return sweeps.solve(part) ? sweeps : undefined;
  }

  /** A matrix for what sweeps would be enough for, with what is saved up. */
  #settle(part: Part): boolean {
    const { matrix } = this.#solvers;
    const { stepsTaken } = this.#simulation;
    const settled = this.#savings.spend(stepsTaken, this.#ways.sways(part), (most) => {
      let used = 0;
      const solve = (): boolean => {
        const done = matrix.solve(part, most - used);
        used += matrix.used;
        return done;
      };
      this.#contacts.keep(part.contacts);
      this.#jointed.begin(part);
      const done = this.#bounces.solve(part, solve, () => false);
      if (done) this.#jointed.limit(part);
      else this.#contacts.putBack(part.contacts);
      return { done, used };
    });
    if (settled) this.#take(part, matrix);
    return settled;
  }

  /** Bullet's solver is to leave it alone. */
  #take(part: Part, solver: Solver): void {
    if (solver.pushApart()) this.#curvedPaths.limitApart(part);
    else {
      for (const body of part.bodies) this.#bodies.change.fill(0, body * SIZE, (body + 1) * SIZE);
      if (part.stands) this.#standing.readWays(part);
    }
    this.#solved.push(part);
    if (part.jointed) this.#joints.tell(part, this.#effects.get(jointSolve));
    this.#grips.tell(part);
    const { ammo } = this.#simulation.engine;
    for (const i of part.contacts) {
      const point = this.#contacts.pointers[i]!;
      this.#distances[i] = solverDistanceAt(ammo, point);
      setSolverDistanceAt(ammo, point, ASIDE);
    }
    this.#corners.tell(part.contacts);
  }

  override solved(dt: number): void {
    const { ammo } = this.#simulation.engine;
    for (const part of this.#solved) {
      for (const body of part.bodies) {
        this.#write(body);
        this.#lookAfter(body, dt);
      }
      for (const i of part.contacts) {
        setSolverDistanceAt(ammo, this.#contacts.pointers[i]!, this.#distances[i]!);
        this.#port.write(i);
      }
      if (part.jointed) for (const i of part.rows) this.#joints.keep(i);
      else this.#rolling.keep(part);
    }
    // What is tied goes on as its ropes let it.
    if (this.#solved.length > 0) this.#effects.caused(ropes)?.goOn(dt);
  }

  /** Contacts may have spun it up within this step: it is to turn as far as that says. */
  #lookAfter(body: number, dt: number): void {
    const v = this.#bodies.velocities;
    const at = body * SIZE + 3;
    if (dot3(v, at, v, at) * dt * dt < BULLETS_TURN ** 2) return;
    const node = this.#simulation.bodyAt(this.#bodies.pointers[body]!);
    if (node) this.#effects.get(fullTurns).need(node);
  }

  #write(body: number): void {
    this.#bodies.writeVelocity(body);
    this.#bodies.writePlace(body);
    const spins = this.#effects.caused(gyroscopic);
    if (!spins || !this.#bodies.isTurned(body, 0)) return;
    const node = this.#simulation.bodyAt(this.#bodies.pointers[body]!);
    if (!node) return;
    // Its spin stays as it is.
    const at = body * SIZE + 3;
    spins.spinOf(node)?.displaced.set(this.#bodies.change.subarray(at, at + 3));
    if (this.#bodies.isTurned(body, TURNED)) spins.turnAside(node, this.#bodies.change, at);
  }
}
