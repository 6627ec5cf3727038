import { Emitter } from '../../base/emitter.js';
import type { Vec3 } from '../../fields/types.js';
import { add, compose, invert, length, scale, subtract, type Pose } from '../../base/math.js';
import type { Body, DragMode } from '../../dynamics/body.js';
import type { Simulation } from '../../dynamics/simulation.js';
import type { DragSpring } from './drag-spring.js';
import { drags, TOP_SPEED } from './effects.js';
import type { KeptHand } from './hand.js';
import type { DragEnd, Hold } from './hold.js';

/** What a drag tells when it is over. */
type Ended = (reason: DragEnd) => void;

/** Seconds after its last move in which a body that is let go still flies on. */
const FLING = 0.1;

/** Held at a place at a time, seconds. */
interface Moment {
  p: Vec3;
  time: number;
}

/** How a spring holds a body, for a snapshot: where in its frame, and what at the other end. */
export interface KeptDrag {
  id: number;
  grip: Vec3;
  target: Vec3;
  hand: KeptHand;
}

/** The effect that carries drags out. */
interface Hands {
  /** Whether a drag still acts on its body. */
  holds(drag: Drag): boolean;
  end(drag: Drag, reason: DragEnd): void;
}

/** One body held at one point, from `body.drag` until it is let go. */
export class Drag implements Hold {
  readonly #hands: Hands;
  readonly #simulation: Simulation;
  readonly body: Body;
  /** The grabbed point in the body's frame. */
  #grip: Vec3;
  #spring: DragSpring | undefined;
  /** Where the grabbed point is to be: world frame, metres. */
  target: Vec3;
  readonly #start: Pose;
  /** Where the body stood when this mode began, and the grabbed point with it. */
  #from!: Pose;
  #point!: Vec3;
  #moments: [before: Moment, last: Moment] | undefined;
  readonly #emitter = new Emitter();
  #over = false;
  /** What its end leaves the body with, before anybody hears of it. */
  #leave = (): void => {};

  constructor(hands: Hands, simulation: Simulation, body: Body, point: Vec3, onend: Ended) {
    this.#hands = hands;
    this.#simulation = simulation;
    this.body = body;
    this.#start = body.pose();
    this.target = [...point];
    this.#grip = compose(invert(body.pose()), at(point)).p;
    // Else time stands still until its code is here.
    if (drags.here) this.#spring = this.spring;
    this.#emitter.on('end', (reason) => onend(reason as DragEnd));
    this.engage();
  }

  save(): KeptDrag {
    const { id } = this.body;
    return { id, grip: [...this.#grip], target: [...this.target], hand: this.spring.save() };
  }

  /** It is the one that held the body when a snapshot was taken. */
  goOn({ grip, target, hand }: KeptDrag): void {
    this.#grip = [...grip];
    this.target = [...target];
    this.#spring = undefined;
    this.spring.goOn(hand);
  }

  get mode(): DragMode {
    return this.body.dragMode;
  }

  /** Until it is let go, by whomever. */
  get held(): boolean {
    return !this.#over;
  }

  /** Where the grabbed point is: world frame, metres. */
  get point(): Vec3 {
    return compose(this.body.pose(), at(this.#grip)).p;
  }

  get spring(): DragSpring {
    return (this.#spring ??= drags.code.spring(this.#simulation, this.body, this.#grip));
  }

  /** The mode begins. */
  engage(): void {
    this.#from = this.body.pose();
    this.#point = this.point;
    this.#moments = undefined;
    this.body.hold(this.mode !== 'spring');
    this.body.wake();
  }

  /** The grabbed point is to be here, world frame, metres. */
  move(point: Vec3): void {
    this.#whole('move', [point], () => this.#move(point));
  }

  /** What a call brings about is told when it is over. */
  #whole(method: string, args: readonly unknown[], work: () => void): void {
    if (!this.#over) this.#simulation.events.call(this, method, args, work);
  }

  #move(point: Vec3): void {
    if (!this.#hands.holds(this)) return this.#hands.end(this, 'disabled');
    const to = this.body.argument<Vec3>('drag', 'SFVec3f', point);
    if (!to) return;
    this.target = to;
    if (this.mode === 'spring') this.body.wake();
    else this.#place(add(this.#from.p, subtract(to, this.#point)));
  }

  #place(p: Vec3): void {
    const { time } = this.#simulation;
    const [before, last] = this.#moments ?? [undefined, { p: this.body.pose().p, time }];
    const now = { p, time };
    // Several moves within one step are one.
    this.#moments = [time > last.time || !before ? last : before, now];
    const pose = { p, q: this.#from.q };
    if (this.mode === 'kinematic') this.body.carryTo(pose);
    else this.body.moveTo(pose);
  }

  /** Lets go. `still`: at rest, whatever it was doing. */
  end(still = false): void {
    this.#whole('end', [still], () => this.#end(still));
  }

  #end(still: boolean): void {
    const velocity = this.mode === 'kinematic' && !still ? this.#thrown() : REST;
    if (still || this.mode !== 'spring') this.#leave = () => this.#goOn(velocity);
    this.#hands.end(this, 'released');
  }

  /** Lets go; what was not moved by a spring returns to where it was grabbed. */
  cancel(): void {
    this.#whole('cancel', [], () => this.#cancel());
  }

  #cancel(): void {
    if (this.mode !== 'spring' && this.body.active)
      this.#leave = () => {
        this.body.moveTo(this.#start);
        this.#goOn(REST);
      };
    this.#hands.end(this, 'cancelled');
  }

  #goOn(velocity: Vec3): void {
    if (this.body.active && this.body.movable)
      this.body.setVelocityAtOrigin({ linear: velocity, angular: REST });
  }

  /** The velocity of its last move. */
  #thrown(): Vec3 {
    if (!this.#moments) return REST;
    const [before, last] = this.#moments;
    const seconds = last.time - before.time;
    if (seconds <= 0 || this.#simulation.time - last.time > FLING) return REST;
    const velocity = scale(subtract(last.p, before.p), 1 / seconds);
    return scale(velocity, Math.min(1, TOP_SPEED / (length(velocity) || 1)));
  }

  /** The effect let go of it. */
  over(reason: DragEnd): void {
    this.#over = true;
    this.body.hold(false);
    this.#leave();
    this.#simulation.events.tell(this.#emitter, 'end', reason);
  }
}

const REST: Vec3 = [0, 0, 0];
const at = (p: Vec3): Pose => ({ p, q: [0, 0, 0, 1] });
