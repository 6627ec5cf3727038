import { hypot } from '../base/exact/index.js';
import type { Vec3 } from '../fields/types.js';
import type { Ammo } from './ammo.js';
import { BODY, MANIFOLD_POINT as POINT } from './offsets.js';

/** Whose corner lies on a face of the other in a point: it stays with that body while it turns. */
export const CORNER = { ofNone: 0, ofA: 1, ofB: -1 } as const;

/** Numbers of a place: both positions and the normal. */
export const PLACE = 9;
const PLACE_AT = [POINT.positionB, POINT.positionA, POINT.normalB];

/**
 * One contact point on the heap, between Bullet's contact search and its solver. One object is moved from point to
 * point, so that a step allocates nothing. A and B are the manifold's bodies; speeds are of A against B.
 */
export class ContactPoint {
  readonly #ammo: Ammo;
  /** Pointers. */
  #point = 0;
  #a = 0;
  #b = 0;
  #floats!: Float32Array;

  constructor(ammo: Ammo) {
    this.#ammo = ammo;
  }

  at(point: number, a: number, b: number): this {
    this.#floats = this.#ammo.HEAPF32;
    this.#point = point;
    this.#a = a;
    this.#b = b;
    return this;
  }

  /** The heap may have grown since. */
  refresh(): this {
    this.#floats = this.#ammo.HEAPF32;
    return this;
  }

  get pointer(): number {
    return this.#point;
  }

  /** The float at an offset of the point; `i` counts on in floats. */
  #get(offset: number, i = 0): number {
    return this.#floats[((this.#point + offset) >> 2) + i]!;
  }

  #put(offset: number, value: number, i = 0): void {
    this.#floats[((this.#point + offset) >> 2) + i] = value;
  }

  #int(offset: number): number {
    return this.#ammo.HEAP32[(this.#point + offset) >> 2]!;
  }

  /** `CORNER` */
  get corner(): number {
    return this.#int(POINT.corner);
  }

  #putInt(offset: number, value: number): void {
    this.#ammo.HEAP32[(this.#point + offset) >> 2] = value;
  }

  // ---- where it is ------------------------------------------------------------------------------------------------

  /** Unit vector from B into A. */
  normal(i: number): number {
    return this.#get(POINT.normalB, i);
  }

  setNormal(i: number, value: number): void {
    this.#put(POINT.normalB, value, i);
  }

  /** World frame, on the surface of B. */
  position(i: number): number {
    return this.#get(POINT.positionB, i);
  }

  setPosition(i: number, value: number): void {
    this.#put(POINT.positionB, value, i);
  }

  positionOnA(i: number): number {
    return this.#get(POINT.positionA, i);
  }

  /** On the surface of A. */
  setPositionOnA(i: number, value: number): void {
    this.#put(POINT.positionA, value, i);
  }

  /** The normal, a new vector; `sign` -1: from A into B. */
  normalVector(sign: 1 | -1 = 1): Vec3 {
    return [this.normal(0) * sign, this.normal(1) * sign, this.normal(2) * sign];
  }

  /** The position, a new vector. */
  positionVector(): Vec3 {
    return [this.position(0), this.position(1), this.position(2)];
  }

  /** Appends both positions and the normal, PLACE numbers. */
  savePlace(to: number[]): void {
    for (const offset of PLACE_AT) for (let i = 0; i < 3; i++) to.push(this.#get(offset, i));
  }

  /** Puts back what `savePlace` saved at `at`. */
  loadPlace(from: readonly number[], at: number): void {
    for (const offset of PLACE_AT) for (let i = 0; i < 3; i++) this.#put(offset, from[at++]!, i);
  }

  /**
   * Distance of the surfaces, metres, negative where they overlap; worked out from both points as Bullet does, since
   * what stands in the point may have been written by us.
   */
  get distance(): number {
    let distance = 0;
    for (let i = 0; i < 3; i++)
      distance += (this.#get(POINT.positionA, i) - this.#get(POINT.positionB, i)) * this.normal(i);
    return distance;
  }

  /** As the solver has it: it leaves out what lies too far away. */
  get solverDistance(): number {
    return this.#get(POINT.distance);
  }

  set solverDistance(metres: number) {
    this.#put(POINT.distance, metres);
  }

  distanceTo(position: readonly number[]): number {
    return hypot(
      this.#get(POINT.positionB, 0) - position[0]!,
      this.#get(POINT.positionB, 1) - position[1]!,
      this.#get(POINT.positionB, 2) - position[2]!,
    );
  }

  // ---- what it lies on --------------------------------------------------------------------------------------------

  /** Whether it lies on a triangle of a mesh, on the side of A (0) or of B (1). */
  onTriangle(side: 0 | 1): boolean {
    return this.#int(side === 0 ? POINT.part0 : POINT.part1) >= 0;
  }

  /** The number of the child of a compound; a triangle overwrites it with its own. */
  child(side: 0 | 1): number {
    return this.#int(side === 0 ? POINT.index0 : POINT.index1);
  }

  /** Of either side the first child, and no triangle. */
  setFirstChildren(): void {
    this.#putInt(POINT.part0, -1);
    this.#putInt(POINT.part1, -1);
    this.#putInt(POINT.index0, 0);
    this.#putInt(POINT.index1, 0);
  }

  // ---- what the solver makes of it ----------------------------------------------------------------------------------

  /** Coulomb's coefficient, of both directions. */
  get friction(): number {
    return this.#get(POINT.friction);
  }

  set friction(coefficient: number) {
    this.#put(POINT.friction, coefficient);
  }

  get restitution(): number {
    return this.#get(POINT.restitution);
  }

  /** Share of the approach that comes back. */
  set restitution(share: number) {
    this.#put(POINT.restitution, share);
  }

  /** Along the normal, N s. */
  get impulse(): number {
    return this.#get(POINT.impulse);
  }

  set impulse(impulse: number) {
    this.#put(POINT.impulse, impulse);
  }

  /** Along both directions of friction, N s. */
  setLateralImpulses(first: number, second: number): void {
    this.#put(POINT.lateralImpulse1, first);
    this.#put(POINT.lateralImpulse2, second);
  }

  /** One number of the impulse along the surface. A fresh point has directions that nobody wrote. */
  lateralPush(i: number): number {
    const first = this.#get(POINT.lateralImpulse1);
    const second = this.#get(POINT.lateralImpulse2);
    return (
      (first === 0 ? 0 : first * this.#get(POINT.direction1, i)) +
      (second === 0 ? 0 : second * this.#get(POINT.direction2, i))
    );
  }

  get directionsGiven(): boolean {
    // One byte: what lies behind it nobody wrote.
    return this.#ammo.HEAPU8[this.#point + POINT.directionsGiven] !== 0;
  }

  /** Whether friction acts along the directions that stand in the point. */
  set directionsGiven(given: boolean) {
    this.#putInt(POINT.directionsGiven, given ? 1 : 0);
  }

  setDirection(which: 0 | 1, x: number, y: number, z: number): void {
    const at = which === 0 ? POINT.direction1 : POINT.direction2;
    this.#put(at, x, 0);
    this.#put(at, y, 1);
    this.#put(at, z, 2);
  }

  direction(which: 0 | 1, i: number): number {
    return this.#get(which === 0 ? POINT.direction1 : POINT.direction2, i);
  }

  motion(which: 0 | 1): number {
    return this.#get(which === 0 ? POINT.motion1 : POINT.motion2);
  }

  /** The speed that friction aims at along a direction, m/s. */
  setMotion(which: 0 | 1, speed: number): void {
    this.#put(which === 0 ? POINT.motion1 : POINT.motion2, speed);
  }

  // ---- how it moves -----------------------------------------------------------------------------------------------

  /** How far the point may have moved in `dt` seconds, metres. */
  reach(dt: number): number {
    return dt * (this.#pace(this.#a) + this.#pace(this.#b));
  }

  #pace(body: number): number {
    const v = (body + BODY.linearVelocity) >> 2;
    return hypot(this.#floats[v]!, this.#floats[v + 1]!, this.#floats[v + 2]!);
  }

  /** Speed along (x, y, z), m/s. */
  speed(x: number, y: number, z: number): number {
    return this.#along(this.#a, x, y, z) - this.#along(this.#b, x, y, z);
  }

  /** Component of the velocity that a body's material has at the point. */
  #along(body: number, x: number, y: number, z: number): number {
    const floats = this.#floats;
    const v = (body + BODY.linearVelocity) >> 2;
    const w = (body + BODY.angularVelocity) >> 2;
    const o = (body + BODY.origin) >> 2;
    const rx = this.#get(POINT.positionB, 0) - floats[o]!;
    const ry = this.#get(POINT.positionB, 1) - floats[o + 1]!;
    const rz = this.#get(POINT.positionB, 2) - floats[o + 2]!;
    return (
      x * (floats[v]! + floats[w + 1]! * rz - floats[w + 2]! * ry) +
      y * (floats[v + 1]! + floats[w + 2]! * rx - floats[w]! * rz) +
      z * (floats[v + 2]! + floats[w]! * ry - floats[w + 1]! * rx)
    );
  }

  /** Of both bodies together, 1/kg. */
  get inverseMass(): number {
    const at = BODY.inverseMass;
    return this.#floats[(this.#a + at) >> 2]! + this.#floats[(this.#b + at) >> 2]!;
  }

  /** Adds the impulse that A got from B here, N s. */
  addImpulse(to: Float64Array): void {
    const push = this.#get(POINT.impulse);
    const rub1 = this.#get(POINT.lateralImpulse1);
    const rub2 = this.#get(POINT.lateralImpulse2);
    for (let i = 0; i < 3; i++)
      to[i]! +=
        push * this.normal(i) +
        rub1 * this.#get(POINT.direction1, i) +
        rub2 * this.#get(POINT.direction2, i);
  }
}
