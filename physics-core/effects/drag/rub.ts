import { add, dot, length, normalize, scale, subtract } from '../../base/math.js';
import type { Vec3 } from '../../fields/types.js';
import { flat, type StepWay } from './smooth-way.js';

/** What acts on a body that lies on another, along the surface, m/s². */
export interface Rub {
  /** Of the surface. */
  normal: Vec3;
  /** What friction gives it at most. */
  grip: number;
  /** What all else gives it: where that alone would take it. */
  pull: StepWay;
}

/** What counts is along the surface, m and m/s. */
export interface Rubbed {
  moved: Vec3;
  speed: Vec3;
  sticks: boolean;
}

/** Times that it may begin or cease to slip in a step: what does so more often goes along. */
const CHANGES = 8;

/** Halvings that find when it does. */
const HALVINGS = 40;

/** m/s: what is slower against what it lies on sticks to it. */
const STICKING = 1e-6;

/**
 * Where friction takes a body in a step of `dt` seconds, from a speed on: it goes along with what it lies on until that
 * speeds up by more than friction gives, and slips, sped up evenly, until both are as fast.
 */
export function rub(way: StepWay, from: Vec3, by: Rub, dt: number): Rubbed {
  const { grip, pull } = by;
  const slip = flat(subtract(way.velocity(0), from), by.normal);
  let sticks = length(slip) < STICKING;
  let moved: Vec3 = [0, 0, 0];
  let speed = from;
  let direction = sticks ? slip : evenly(way, from, by, dt);
  let time = 0;
  for (let change = 0; change < CHANGES; change++) {
    const since = time;
    if (sticks) {
      time = firstAbove((t) => length(lackOf(way, by, t)) - grip, since, dt);
      moved = add(moved, subtract(way.place(time), way.place(since)));
      speed = way.velocity(time);
      direction = normalize(lackOf(way, by, time));
    } else {
      const slips = slipFrom(speed, since, scale(direction, grip), pull);
      time = crossing((t) => dot(direction, subtract(slips.speed(t), way.velocity(t))), since, dt);
      moved = add(moved, slips.way(time));
      speed = slips.speed(time);
    }
    if (time === dt) return { moved, speed, sticks };
    sticks = !sticks;
  }
  return { moved: add(moved, subtract(way.place(dt), way.place(time))), speed, sticks: true };
}

/** What friction has to give it to go along, m/s². */
const lackOf = (way: StepWay, { pull, normal }: Rub, t: number): Vec3 =>
  flat(subtract(way.acceleration(t), pull.acceleration(t)), normal);

/** From a speed and a time on. */
function slipFrom(speed: Vec3, since: number, rubbed: Vec3, pull: StepWay) {
  const own = subtract(speed, pull.velocity(since));
  return {
    speed: (t: number): Vec3 => add(add(own, pull.velocity(t)), scale(rubbed, t - since)),
    way(t: number): Vec3 {
      const even = add(scale(own, t - since), scale(rubbed, (t - since) ** 2 / 2));
      return add(even, subtract(pull.place(t), pull.place(since)));
    },
  };
}

/**
 * The direction in which it is rubbed: the mean of those at both ends of the step, since what slips round a bend turns. What
 * slips so slowly that it may cease to is rubbed towards where it has to go: what it does sideways is gone at once.
 */
function evenly(way: StepWay, from: Vec3, { normal, grip, pull }: Rub, dt: number): Vec3 {
  const slip = flat(subtract(way.velocity(0), from), normal);
  const pulled = subtract(pull.velocity(dt), pull.velocity(0));
  const lack = flat(subtract(way.velocity(dt), add(from, pulled)), normal);
  const first = normalize(slip);
  const last = normalize(lack);
  if (dot(first, last) <= 0) return first;
  if (Math.min(length(slip), length(lack)) <= grip * dt) return last;
  const push = scale(normalize(add(first, last)), grip * dt);
  return normalize(add(first, normalize(subtract(lack, push))));
}

/** When a function first is above zero; `to`: not before. */
const firstAbove = (f: (t: number) => number, from: number, to: number): number =>
  f(from) > 0 ? from : crossing(f, from, to);

/** When a function rises through zero, which it does at most once; `to`: not before. */
function crossing(f: (t: number) => number, from: number, to: number): number {
  if (f(to) <= 0) return to;
  let low = from;
  let high = to;
  for (let i = 0; i < HALVINGS; i++) {
    const middle = (low + high) / 2;
    if (f(middle) > 0) high = middle;
    else low = middle;
  }
  return high === to ? low : high;
}
