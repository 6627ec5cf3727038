import { Emitter } from '../../base/emitter.js';
import { add, scale, subtract } from '../../base/math.js';
import type { Simulation } from '../../dynamics/simulation.js';
import type { Vec3 } from '../../fields/types.js';
import { drags, SWIFTNESS } from './effects.js';
import type { Hand, KeptHand } from './hand.js';
import type { DragEnd, Hold } from './hold.js';
import type { Grabbed, SoftPoints } from './soft.js';

/** Which points of mass are held, and what share of the hand each has. */
export interface SoftGrip {
  readonly points: number[];
  readonly shares: number[];
  /** Of the surface there, a unit vector. */
  readonly normal: Vec3;
}

/**
 * Metres by which a hand lifts a surface that it takes. What is flat and pushed together within its plane knew no side to fold
 * to, and would lie there in itself. (Fact: a flat cloth that is pushed together folds, and falls open again.)
 */
const LIFT = 1e-5;

/** For a snapshot. */
export interface KeptSoftDrag extends SoftGrip {
  id: number;
  offset: Vec3;
  target: Vec3;
  hand: KeptHand;
}

/** What carries drags out. */
interface Hands {
  holds(drag: SoftDrag): boolean;
  end(drag: SoftDrag, reason: DragEnd): void;
}

/**
 * A rope, a cloth or a soft body held at one place: by the spring that bodies are held by (DragSpring), as stiff as all of it
 * weighs. Here it acts on points of mass, and by its implicit Euler each of them is, for the step, one that weighs more by what
 * the damper does, and goes as fast as the hand would have it: so whatever joins the points finds the hand in their masses, and
 * the hand feels all that hangs there.
 */
export class SoftDrag implements Hold {
  readonly mode = 'spring';
  readonly #hands: Hands;
  readonly #simulation: Simulation;
  readonly body: Grabbed;
  readonly of: SoftPoints;
  #grip: SoftGrip;
  /** From what is held to the grabbed point: a hand takes hold beside a point, too. */
  #offset: Vec3;
  target: Vec3;
  #hand: Hand;
  #mass = 0;
  readonly #emitter = new Emitter();
  #over = false;
  #still = false;

  constructor(
    hands: Hands,
    simulation: Simulation,
    [body, of]: [Grabbed, SoftPoints],
    grip: SoftGrip,
    point: Vec3,
    onend: (reason: DragEnd) => void,
  ) {
    this.#hands = hands;
    this.#simulation = simulation;
    this.body = body;
    this.of = of;
    this.#grip = grip;
    this.target = [...point];
    this.#offset = subtract(point, this.#of(of.places));
    this.#hand = drags.code.hand(this.#of(of.places));
    this.#emitter.on('end', (reason) => onend(reason as DragEnd));
  }

  save(): KeptSoftDrag {
    const { points, shares, normal } = this.#grip;
    return {
      id: this.body.id,
      points: [...points],
      shares: [...shares],
      normal: [...normal],
      offset: [...this.#offset],
      target: [...this.target],
      hand: this.#hand.save(),
    };
  }

  /** It is the one that held it when a snapshot was taken. */
  goOn({ points, shares, normal, offset, target, hand }: KeptSoftDrag): void {
    this.#grip = { points: [...points], shares: [...shares], normal: [...normal] };
    this.#offset = [...offset];
    this.target = [...target];
    this.#hand = drags.code.handAs(hand);
  }

  get held(): boolean {
    return !this.#over;
  }

  get point(): Vec3 {
    return add(this.#of(this.of.places), this.#offset);
  }

  /** Of what is held, of three numbers for each point of mass. */
  #of(numbers: Float64Array): Vec3 {
    const { points, shares } = this.#grip;
    const sum: Vec3 = [0, 0, 0];
    points.forEach((i, n) => {
      for (let k = 0; k < 3; k++) sum[k]! += shares[n]! * numbers[3 * i + k]!;
    });
    return sum;
  }

  // ---- what people do -------------------------------------------------------------------------------------------------

  move(point: Vec3): void {
    this.#whole('move', [point], () => {
      if (!this.#hands.holds(this)) return this.#hands.end(this, 'disabled');
      const to = this.body.place('drag', point);
      if (to) this.target = to;
    });
  }

  end(still = false): void {
    this.#whole('end', [still], () => {
      this.#still = still;
      this.#hands.end(this, 'released');
    });
  }

  /** A spring puts nothing back. */
  cancel(): void {
    this.#whole('cancel', [], () => this.#hands.end(this, 'cancelled'));
  }

  /** What a call brings about is told when it is over. */
  #whole(method: string, args: readonly unknown[], work: () => void): void {
    if (!this.#over) this.#simulation.events.call(this, method, args, work);
  }

  over(reason: DragEnd): void {
    this.#over = true;
    if (this.#still) this.of.velocities.fill(0);
    this.#simulation.events.tell(this.#emitter, 'end', reason);
  }

  // ---- a step ---------------------------------------------------------------------------------------------------------

  /** The hand makes its step; `mass`: of all that it has to move, kg. */
  begin(mass: number, dt: number): void {
    const { places, velocities } = this.of;
    this.#mass = mass;
    const reach = this.#hand.strength / SWIFTNESS ** 2;
    const lifted = add(this.target, scale(this.#grip.normal, LIFT));
    const target = subtract(lifted, this.#offset);
    this.#hand.move(target, this.#of(places), this.#of(velocities), reach, dt);
  }

  /**
   * What acts in a part of the step, `time` seconds until `left` seconds before its end, on points that were at `before` and
   * would go to `places`: `act` is told of each what it weighs more by, and the N s that come with that.
   */
  act(
    before: Float64Array,
    time: number,
    left: number,
    act: (point: number, weight: number, push: Vec3) => void,
  ): void {
    const { points, shares } = this.#grip;
    const { position, velocity } = this.#hand;
    const at = this.#of(before);
    const h = SWIFTNESS * time;
    const stiff = this.#mass * h * SWIFTNESS;
    const weight = this.#mass * h * (h + 2);
    const push: Vec3 = [0, 0, 0];
    points.forEach((i, n) => {
      for (let k = 0; k < 3; k++)
        push[k] =
          shares[n]! *
          (stiff * (position[k]! - left * velocity[k]! - at[k]!) +
            2 * this.#mass * h * velocity[k]!);
      act(i, shares[n]! * weight, push);
    });
  }
}
