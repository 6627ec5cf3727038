import { Emitter } from '../../base/emitter.js';
import { add, scale, subtract } from '../../base/math.js';
import type { Simulation } from '../../dynamics/simulation.js';
import type { Vec3 } from '../../fields/types.js';
import { drags, SWIFTNESS } from './effects.js';
import type { Hand, KeptHand } from './hand.js';
import type { DragEnd, Hold } from './hold.js';
import type { Grabbed, SoftPoints } from './soft.js';
import type { SoftPlace } from './soft-places.js';

/** Which points of mass are held, and what share of the hand each has. */
export interface SoftGrip {
  readonly points: number[];
  readonly shares: number[];
  /** The same as it is seen: points of the surface, which are no points of mass where these lie within. */
  readonly seen: SoftPlace;
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
  seenOff: Vec3;
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
  /** From what is held, and from where that is seen, to the grabbed point: a hand takes hold beside it, too. */
  #offset: Vec3;
  #seenOff: Vec3;
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
    this.#seenOff = subtract(point, this.#seen);
    this.#hand = drags.code.hand(this.#of(of.places));
    this.#emitter.on('end', (reason) => onend(reason as DragEnd));
  }

  save(): KeptSoftDrag {
    return structuredClone({
      ...this.#grip,
      id: this.body.id,
      offset: this.#offset,
      seenOff: this.#seenOff,
      target: this.target,
      hand: this.#hand.save(),
    });
  }

  /** It is the one that held it when a snapshot was taken. */
  goOn(kept: KeptSoftDrag): void {
    const { points, shares, seen, offset, seenOff, target, hand } = structuredClone(kept);
    this.#grip = { points, shares, seen };
    this.#offset = offset;
    this.#seenOff = seenOff;
    this.target = target;
    this.#hand = drags.code.handAs(hand);
  }

  get held(): boolean {
    return !this.#over;
  }

  get point(): Vec3 {
    return add(this.#seen, this.#seenOff);
  }

  /** Also where its steps are taken on another thread. */
  get #seen(): Vec3 {
    return mean(this.#grip.seen, this.body.places ?? []);
  }

  /** Of what is held, of three numbers for each point of mass. */
  #of(numbers: Float64Array): Vec3 {
    return mean(this.#grip, numbers);
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
    const lifted = add(this.target, scale(this.#grip.seen.normal, LIFT));
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

function mean({ points, shares }: Omit<SoftGrip, 'seen'>, numbers: ArrayLike<number>): Vec3 {
  const sum: Vec3 = [0, 0, 0];
  points.forEach((i, n) => {
    for (let k = 0; k < 3; k++) sum[k]! += shares[n]! * (numbers[3 * i + k] ?? 0);
  });
  return sum;
}
