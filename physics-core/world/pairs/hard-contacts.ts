import { compose, dot, length, subtract } from '../../base/math.js';
import { keyOf } from '../../effects/contacts/touches.js';
import type { Body } from '../../dynamics/body.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { ContactPoint } from '../../engine/contact-point.js';
import { hitShapeOf } from '../../effects/hits/hit-shape.js';
import { eachContactPoint } from '../../effects/contacts/contact-points.js';
import type { HardContacts as Reports, PiledWorld } from '../../effects/effect/chunks.js';
import { Streaks } from './streaks.js';
import { UnlikeMasses } from './unlike-masses.js';

/** Seconds between two looks, and looks in a row that must find the same: what hits is thrown out at once. */
const PAUSE = 0.1;
const LOOKS = 4;

/** From this share of its least extent in an obstacle on a body is looked at in every step. */
const SINKING = 0.1;

/** From so many times the mass of what hangs on joints on, what lies on it is looked at: a weight on a bridge. */
const HEAVY = 50;

/** From here on every step is looked at: a weight that needs no longer to be somewhere else, m/s². */
const STRONG_GRAVITY = 200;

/** Share of its own least extent that a body's weight may take it in a step. */
const FAR = 0.5;

/** Tells of what contacts do not hold: seldom looked for, so that it costs next to nothing. */
export class HardContacts implements Reports {
  readonly #simulation: Simulation;
  readonly #unlike: UnlikeMasses;
  readonly #sunk = new Streaks();
  #point: ContactPoint | undefined;
  #since = Infinity;
  #strong = false;
  /** When all were weighed, and steps so long: the greatest mass and the smallest one, kg. */
  #reviews = -1;
  #dt = 0;
  #most = 0;
  #least = Infinity;
  /** Something is on the way to be told of. */
  #sinking = false;

  constructor(world: PiledWorld) {
    this.#simulation = world;
    this.#unlike = new UnlikeMasses(world);
  }

  forget(): void {
    this.#since = Infinity;
    this.#reviews = -1;
    this.#unlike.forget();
    this.#sunk.forget();
  }

  look(dt: number): void {
    this.#since += dt;
    const due = this.#since >= PAUSE;
    if (due) this.#weigh(dt);
    if (due || this.#strong || this.#sinking) this.#findSunk();
  }

  #weigh(dt: number): void {
    this.#since = 0;
    const { reviews } = this.#simulation.bodies.moving;
    if (this.#strong || reviews !== this.#reviews || dt !== this.#dt) this.#weighAll(dt);
    this.#reviews = reviews;
    this.#dt = dt;
    this.#unlike.look(this.#most, this.#least);
  }

  #weighAll(dt: number): void {
    this.#strong = false;
    let most = 0;
    let least = Infinity;
    for (const body of this.#simulation.bodies) {
      // `movable` asks two fields and `gravity` a third: only of few.
      if (!body.isDynamic) continue;
      const { mass } = body.mass;
      if (mass > most) most = mass;
      if (mass < least) least = mass;
      const { appliedGravity } = body;
      if (dot(appliedGravity, appliedGravity) < STRONG_GRAVITY ** 2 || !body.movable) continue;
      this.#strong = true;
      const gravity = length(body.gravity);
      if (gravity * dt * dt > FAR * body.leastExtent) this.#tellFar(body, gravity, dt);
    }
    this.#most = most;
    this.#least = least;
  }

  #findSunk(): void {
    const point = (this.#point ??= new ContactPoint(this.#simulation.engine.ammo));
    this.#sunk.begin();
    this.#sinking = false;
    eachContactPoint(this.#simulation, (pointer, a, b) => {
      // As in `#weighAll`: most points lie between two that move, and weigh on nothing that hangs.
      const alike = a.isDynamic === b.isDynamic;
      if (alike && !weighsOnJoints(a, b)) return;
      point.at(pointer, a.pointer, b.pointer);
      const moves = alike ? a.leastExtent < b.leastExtent : a.isDynamic;
      this.#lookAt(point, a, b, moves ? a : b);
    });
  }

  /**
   * What moves has come halfway through what does not; or of something heavy and what it weighs on the thinner one into the
   * other. Only of what is convex the middle says so.
   */
  #lookAt(point: ContactPoint, a: Body, b: Body, moving: Body): void {
    if (-point.distance < SINKING * moving.leastExtent) return;
    this.#sinking = true;
    const height = heightOver(point, moving, moving === a ? 1 : -1);
    if (!(height < 0)) return;
    // Under a strong gravity the next look may be too late.
    if (this.#sunk.note(keyOf(a, b)) < (this.#strong ? 1 : LOOKS)) return;
    if (a.isDynamic && (!b.isDynamic || a.mass.mass > b.mass.mass)) this.#tellSunk(a, b);
    else this.#tellSunk(b, a);
  }

  #tellFar(body: Body, gravity: number, dt: number): void {
    const way = gravity * dt * dt;
    this.#simulation.report(
      {
        code: 'strong-gravity',
        severity: 'warning',
        value: gravity,
        used: 'the present accuracy',
        message: `${body.label}: gravity of ${show(gravity)} m/s² takes it ${show(way)} m in a step, more than half its own size: contacts may not hold it; a finer accuracy does, or less gravity`,
      },
      body,
    );
  }

  #tellSunk(sunk: Body, obstacle: Body): void {
    this.#simulation.report(
      {
        code: 'sunk',
        severity: 'warning',
        attribute: 'position',
        used: 'the present accuracy',
        message: `${sunk.label} is pressed through ${obstacle.label}: contacts do not hold what weighs on it; a finer accuracy, less gravity or masses more alike would`,
      },
      sunk,
    );
  }
}

function weighsOnJoints(a: Body, b: Body): boolean {
  if (a.joints.size === b.joints.size) return false;
  const [hanging, other] = a.joints.size > b.joints.size ? [a, b] : [b, a];
  return other.mass.mass > HEAVY * hanging.mass.mass;
}

/** Of the middle of a body over the surface that it touches, metres; NaN where it has several parts or an unknown middle. */
function heightOver(point: ContactPoint, body: Body, sign: 1 | -1): number {
  const part = body.solidParts.length === 1 ? body.solidParts[0]! : undefined;
  if (!part || !hitShapeOf(part, body)) return NaN;
  const middle = compose(body.poseInBullet(), part.pose).p;
  return sign * dot(point.normalVector(), subtract(middle, point.positionVector()));
}

const show = (value: number): string => String(Number(value.toPrecision(3)));
