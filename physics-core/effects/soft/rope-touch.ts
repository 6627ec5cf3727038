import { dot3 } from '../../base/flat-math.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { ROPE_RETURN } from '../../solver/tolerances.js';
import { FREE } from '../../solver/ropes/strand.js';
import { SPOTS, type Spots } from '../../solver/ropes/spots.js';
import { MET, METS, Obstacles } from '../particles/collide/obstacles.js';
import { CoilSearch } from './coil-search.js';
import { Flying } from './flying.js';
import { OnLink, SPOT } from './on-link.js';
import type { Rope } from './rope.js';
import type { TiedGroup } from './tied-group.js';
import { AHEAD, SAGS } from './tolerances.js';
import { TouchedBodies } from './touched-bodies.js';

const met = new Float64Array(METS);
const from = new Float64Array(3);
const to = new Float64Array(3);
const link = new Float64Array(3);
/** Of a link, the shares between which it is out of what its points are tied within. */
const outer = new Float64Array(2);
const point = new Float64Array(3);
const force = new Float64Array(3);

/** Numbers of what was found on a link. */
const NUMBERS = 9;

/** What ropes touch in a step, by their points and by their links between them, and what they do to it. */
export class RopeTouch {
  readonly #obstacles: Obstacles;
  readonly #bodies: TouchedBodies;
  readonly #onLink: OnLink;
  readonly #flying: Flying;
  readonly #coils = new CoilSearch();
  #dt = 0;
  /** Of each point, how far away it looks for something, metres. */
  #reaches = new Float64Array(0);

  constructor(simulation: Simulation) {
    this.#obstacles = new Obstacles(simulation);
    this.#bodies = new TouchedBodies(simulation);
    this.#onLink = new OnLink(this.#obstacles);
    this.#flying = new Flying(simulation);
  }

  /** Where bodies are when a step begins, however they came there. */
  take(dt: number): void {
    this.#obstacles.forget();
    this.#obstacles.take(dt);
    this.#dt = dt;
    this.#bodies.begin();
  }

  /** A point is tied to a body, maybe deep within it: so much of the rope does not touch that. */
  comeOut({ strand, settings: { radius }, within }: Rope, index: number, slot: number): void {
    const { places, lengths, points } = strand;
    for (let k = 0; k < 3; k++) from[k] = places[3 * index + k]!;
    const inside = this.#obstacles.meet(from, from, 0, met, 1, 1) && met[MET.body] === slot;
    const most = (inside ? met[MET.depth]! : 0) + 2 * radius;
    let first = index;
    let last = index;
    for (let far = 0; first > 0 && far < most; first--) far += lengths[first - 1]!;
    for (let far = 0; last < points - 1 && far < most; last++) far += lengths[last]!;
    within.push({ slot, index, most, first, last });
  }

  /** Who each may touch in a step that begins. All that touch a body push it by themselves: each counts for its share. */
  look({ ropes }: TiedGroup, dt: number): void {
    for (const rope of ropes) this.#look(rope, dt);
    for (const { strand, touched, touchedBetween } of ropes) {
      this.#share(strand.knots, touched);
      this.#share(strand.between, touchedBetween);
    }
  }

  #share({ count, yields, recent }: Spots, touched: Int32Array): void {
    if (recent === 0) return;
    for (let c = 0; c < count; c++)
      if (touched[c]! >= 0) yields[c]! *= this.#bodies.counts[touched[c]!]!;
  }

  #look(rope: Rope, dt: number): void {
    const { strand, settings, touched, touchedBetween } = rope;
    const { points, knots, between } = strand;
    forget(knots, touched);
    forget(between, touchedBetween);
    if (!(settings.radius > 0)) return;
    if (this.#reaches.length < points) this.#reaches = new Float64Array(2 * points);
    for (let i = 0; i < points; i++) this.#reaches[i] = this.#reachOf(rope, i, dt);
    // Around a link there is all that its points look at: where it meets nothing, nothing else is asked.
    let isNear = this.#isLinkNear(rope, 0);
    let wasNear = false;
    for (let i = 0; i < points; i++) {
      if (isNear || wasNear) this.#lookAtPoint(rope, i, dt);
      if (wasNear) this.#lookAtLink(rope, i - 1, dt);
      wasNear = isNear;
      isNear = i + 2 < points && this.#isLinkNear(rope, i + 1);
    }
    this.#flying.look(rope, dt, this.#meetInFlight);
    if (strand.coils) this.#coils.look(rope, strand.coils, this.#reaches, dt);
  }

  /** What flies into a link does so across it: along it that is as it is. */
  readonly #meetInFlight = (rope: Rope, i: number, share: number, slot: number): void => {
    const { strand, settings, within, touchedBetween } = rope;
    const { between, holders, places, free } = strand;
    const c = touchedBetween[SPOTS * i]! < 0 ? SPOTS * i : SPOTS * i + 1;
    if (isGiven(holders, i)) return;
    if (touchedBetween[c]! >= 0 || touchedBetween[SPOTS * i] === slot) return;
    if (isWithin(within, i, i + 1, slot)) return;
    let along = 0;
    let square = 0;
    for (let k = 0; k < 3; k++) {
      const j = 3 * i + k;
      link[k] = places[j + 3]! - places[j]!;
      from[k] = places[j]! + share * link[k]!;
    }
    this.#bodies.know(slot);
    this.#bodies.velocityAt(slot, from, to, 0);
    for (let k = 0; k < 3; k++) {
      const j = 3 * i + k;
      to[k] = this.#dt * (free[j]! + share * (free[j + 3]! - free[j]!) - to[k]!);
      along += to[k]! * link[k]!;
      square += link[k]! ** 2;
    }
    for (let k = 0; k < 3; k++) to[k]! += from[k]! - (along / square) * link[k]!;
    if (!this.#obstacles.meet(from, to, settings.radius, met, 1, 1)) return;
    if (met[MET.body] !== slot || !(met[MET.share]! > 0)) return;
    touchedBetween[c] = slot;
    between.shares[c] = share;
    let gap = 0;
    for (let k = 0; k < 3; k++) {
      const normal = (between.normals[3 * c + k] = met[MET.normal + k]!);
      point[k] = met[MET.point + k]!;
      gap += met[MET.share]! * normal * (from[k]! - to[k]!);
    }
    this.#note(between, c, gap, settings.friction, slot, this.#dt);
  };

  #reachOf(
    { strand: { free, holders }, settings: { radius } }: Rope,
    i: number,
    dt: number,
  ): number {
    let square = 0;
    if (holders[i] === FREE) for (let k = 3 * i; k < 3 * i + 3; k++) square += (dt * free[k]!) ** 2;
    return radius + AHEAD * radius + Math.sqrt(square);
  }

  #isLinkNear({ strand: { places } }: Rope, i: number): boolean {
    for (let k = 0; k < 3; k++) {
      from[k] = places[3 * i + k]!;
      to[k] = places[3 * i + 3 + k]!;
    }
    return this.#obstacles.isNear(from, to, Math.max(this.#reaches[i]!, this.#reaches[i + 1]!));
  }

  #lookAtPoint(
    { strand, settings: { radius, friction }, within, touched }: Rope,
    i: number,
    dt: number,
  ) {
    const { knots, holders, places, free } = strand;
    if (holders[i] !== FREE) return;
    for (let k = 0; k < 3; k++) {
      from[k] = places[3 * i + k]!;
      to[k] = from[k]! + dt * free[3 * i + k]!;
    }
    if (!this.#meets(radius, this.#reaches[i]!) || isWithin(within, i, i, met[MET.body]!)) return;
    touched[i] = met[MET.body]!;
    for (let k = 0; k < 3; k++) {
      knots.normals[3 * i + k] = met[MET.normal + k]!;
      point[k] = met[MET.point + k]!;
      to[k] = from[k]! - point[k]!;
    }
    this.#note(knots, i, dot3(to, 0, knots.normals, 3 * i) - radius, friction, touched[i]!, dt);
  }

  /** Thin things and edges come between points: where these do not both touch the same, and lie flat on it. */
  #lookAtLink(rope: Rope, i: number, dt: number): void {
    const { strand, settings, within, touchedBetween } = rope;
    const { between, holders, places } = strand;
    const { radius, friction } = settings;
    if (isGiven(holders, i) || this.#liesFlat(rope, i)) return;
    for (let k = 0; k < 3; k++) {
      from[k] = places[3 * i + k]!;
      to[k] = places[3 * i + 3 + k]!;
    }
    const reach = Math.max(this.#reaches[i]!, this.#reaches[i + 1]!);
    const count = this.#comesOut(rope, i, reach) ? this.#onLink.look(from, to, reach, radius) : 0;
    const first = SPOTS * i;
    if (count < SPOTS) between.inherit(first, first + 1);
    const { found } = this.#onLink;
    for (let n = 0; n < count; n++) {
      const at = NUMBERS * n;
      const slot = found[at + SPOT.slot]!;
      if (isWithin(within, i, i + 1, slot)) continue;
      const c = first + n;
      touchedBetween[c] = slot;
      between.shares[c] = outer[0]! + found[at + SPOT.share]! * (outer[1]! - outer[0]!);
      for (let k = 0; k < 3; k++) {
        between.normals[3 * c + k] = found[at + SPOT.normal + k]!;
        point[k] = found[at + SPOT.point + k]!;
      }
      this.#note(between, c, found[at + SPOT.gap]! - radius, friction, slot, dt);
    }
  }

  /** What comes out of a body it is tied within is looked at from there on: else that would be all that is seen. */
  #comesOut({ strand: { lengths }, within }: Rope, i: number, reach: number): boolean {
    outer[0] = 0;
    outer[1] = 1;
    for (const { index, most } of within) {
      let far = most + reach;
      for (let n = index; n < i; n++) far -= lengths[n]!;
      for (let n = index - 1; n > i; n--) far -= lengths[n]!;
      if (!(far > 0)) continue;
      const share = far / lengths[i]!;
      if (index <= i) outer[0] = Math.max(outer[0]!, share);
      else outer[1] = Math.min(outer[1]!, 1 - share);
    }
    if (!(outer[0]! < outer[1]!)) return false;
    for (let k = 0; k < 3; k++) {
      const start = from[k]!;
      const way = to[k]! - start;
      from[k] = start + outer[0]! * way;
      to[k] = start + outer[1]! * way;
    }
    return true;
  }

  /** Whether its points lie on the same, so flat that the link is hardly in it between them. */
  #liesFlat(
    { strand: { knots, lengths }, touched, settings: { radius } }: Rope,
    i: number,
  ): boolean {
    if (touched[i]! < 0 || touched[i] !== touched[i + 1]) return false;
    let square = 0;
    for (let k = 3 * i; k < 3 * i + 3; k++)
      square += (knots.normals[k + 3]! - knots.normals[k]!) ** 2;
    // The arc of a circle between two normals is so high above its chord.
    return lengths[i]! * Math.sqrt(square) < 8 * SAGS * radius;
  }

  /** On its way, or near to it. */
  #meets(radius: number, reach: number): boolean {
    const obstacles = this.#obstacles;
    return (
      obstacles.meet(from, from, reach, met, 1, 1) || obstacles.meet(from, to, radius, met, 1, 1)
    );
  }

  /** It touches a body at `point`. What begins inside comes out in time. */
  #note(spots: Spots, c: number, gap: number, friction: number, slot: number, dt: number): void {
    const bodies = this.#bodies;
    spots.touch(c);
    spots.frictions[c] = friction;
    spots.gaps[c] = Math.max(gap, -ROPE_RETURN * dt);
    bodies.add(slot);
    bodies.velocityAt(slot, point, spots.surfaces, 3 * c);
    spots.yields[c] = bodies.softness(slot, point, spots.normals, 3 * c);
  }

  /** What is touched is pushed the other way, evenly through the step. */
  push({ ropes }: TiedGroup, dt: number): void {
    for (const { strand, touched, touchedBetween } of ropes) {
      this.#push(strand.places, strand.knots, touched, dt);
      this.#push(strand.places, strand.between, touchedBetween, dt);
    }
  }

  #push(places: Float64Array, spots: Spots, touched: Int32Array, dt: number): void {
    const { count, recent, firsts, shares, normals, presses, rubs, gaps } = spots;
    if (recent === 0) return;
    for (let c = 0; c < count; c++) {
      if (touched[c]! < 0 || !(presses[c]! > 0)) continue;
      const share = shares[c]!;
      const one = 3 * firsts[c]!;
      const two = share > 0 ? one + 3 : one;
      for (let k = 0; k < 3; k++) {
        const j = 3 * c + k;
        const place = places[one + k]!;
        force[k] = -(presses[c]! * normals[j]! + rubs[j]!) / dt;
        point[k] = place + share * (places[two + k]! - place) - gaps[c]! * normals[j]!;
      }
      this.#bodies.push(touched[c]!, point, force);
    }
  }
}

function forget({ touches, recent }: Spots, touched: Int32Array): void {
  if (recent === 0) return;
  touches.fill(0);
  touched.fill(-1);
}

/** One body, or nobody, has both points of a link. */
const isGiven = (holders: Int32Array, i: number): boolean =>
  holders[i] !== FREE && holders[i] === holders[i + 1];

/** Whether what lies between two points of a rope, or is one, comes out of a body that it is tied within. */
function isWithin(within: Rope['within'], first: number, last: number, slot: number): boolean {
  const middle = (first + last) / 2;
  for (const each of within)
    if (each.slot === slot && middle >= each.first && middle <= each.last) return true;
  return false;
}
