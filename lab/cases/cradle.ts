import type { Case, CaseBody, Vec3 } from '../case.js';
import { offPaths, roundingOf, type Path } from './paths.js';

const GRAVITY = 9.81;
const COUNT = 5;
const RADIUS = 0.1;
const GAP = 0.001;
/** From the anchor to a ball's centre. */
const ARM = 1;
/** How far the first ball is raised, radians. */
const RAISED = Math.PI / 6;
const SECONDS = 1.5;

/** Seconds of a step of the reference; half of it changes no place by more than 1e-8 m. */
const STEP = 1 / 7680;

const anchor = (i: number): Vec3 => [i * (2 * RADIUS + GAP), ARM, 0];

/** Angles and rates of all balls, from hanging straight, positive towards +x. */
interface State {
  angle: number[];
  rate: number[];
}

/** A ball on a rod without mass, which turns with it. */
const PULL = (-GRAVITY * ARM) / (ARM ** 2 + 0.4 * RADIUS ** 2);
const spinUp = (angle: number): number => PULL * Math.sin(angle);

/** One pendulum by the classical Runge-Kutta rule. */
function swing(angle: number, rate: number, h: number): [number, number] {
  const a1 = spinUp(angle);
  const r2 = rate + (h / 2) * a1;
  const a2 = spinUp(angle + (h / 2) * rate);
  const r3 = rate + (h / 2) * a2;
  const a3 = spinUp(angle + (h / 2) * r2);
  const r4 = rate + h * a3;
  const a4 = spinUp(angle + h * r3);
  return [
    angle + (h / 6) * (rate + 2 * r2 + 2 * r3 + r4),
    rate + (h / 6) * (a1 + 2 * a2 + 2 * a3 + a4),
  ];
}

const place = (i: number, angle: number): Vec3 => {
  const [x, y] = anchor(i);
  return [x + ARM * Math.sin(angle), y - ARM * Math.cos(angle), 0];
};

/** Metres between balls i and i + 1, and the speed at which they near each other. */
function between({ angle, rate }: State, i: number): { gap: number; approach: number } {
  const [ax, ay] = place(i, angle[i]!);
  const [bx, by] = place(i + 1, angle[i + 1]!);
  const size = Math.hypot(bx - ax, by - ay);
  const [nx, ny] = [(bx - ax) / size, (by - ay) / size];
  return {
    gap: size - 2 * RADIUS,
    approach: rate[i]! * lever(angle[i]!, nx, ny) - rate[i + 1]! * lever(angle[i + 1]!, nx, ny),
  };
}

/** Of a push along (x, y) through a ball's centre about its anchor. */
const lever = (angle: number, x: number, y: number): number =>
  ARM * (x * Math.cos(angle) + y * Math.sin(angle));

/** Equal balls without friction: the push between them turns their approach round. */
function strike(state: State, i: number): void {
  const { angle, rate } = state;
  const [ax, ay] = place(i, angle[i]!);
  const [bx, by] = place(i + 1, angle[i + 1]!);
  const size = Math.hypot(bx - ax, by - ay);
  const [nx, ny] = [(bx - ax) / size, (by - ay) / size];
  const [u, v] = [lever(angle[i]!, nx, ny), lever(angle[i + 1]!, nx, ny)];
  const push = (2 * (rate[i]! * u - rate[i + 1]! * v)) / (u * u + v * v);
  rate[i]! -= push * u;
  rate[i + 1]! += push * v;
}

/** The seconds, up to `h`, after which two balls meet; Infinity where they do not. */
function meeting(state: State, i: number, h: number): number {
  const after = (t: number): State => advanced(state, t);
  if (between(after(h), i).gap >= 0 || between(state, i).approach <= 0) return Infinity;
  let [low, high] = [0, h];
  while (high - low > 1e-13) {
    const middle = (low + high) / 2;
    if (between(after(middle), i).gap > 0) low = middle;
    else high = middle;
  }
  return high;
}

function advanced({ angle, rate }: State, h: number): State {
  const all = angle.map((each, i) => swing(each, rate[i]!, h));
  return { angle: all.map(([a]) => a), rate: all.map(([, r]) => r) };
}

/** Through one step, hit after hit. */
function step(state: State, h: number): State {
  let [now, left] = [state, h];
  while (left > 0) {
    const times = Array.from({ length: COUNT - 1 }, (_, i) => meeting(now, i, left));
    const first = Math.min(...times);
    if (first === Infinity) return advanced(now, left);
    now = advanced(now, first);
    strike(now, times.indexOf(first));
    left -= first;
  }
  return now;
}

/** All angles at every 1/60 s. */
function reference(): number[][] {
  const per = Math.round(1 / 60 / STEP);
  let state: State = {
    angle: Array.from({ length: COUNT }, (_, i) => (i === 0 ? -RAISED : 0)),
    rate: new Array<number>(COUNT).fill(0),
  };
  const looks = [state.angle];
  for (let i = 0; i < SECONDS * 60; i++) {
    for (let k = 0; k < per; k++) state = step(state, STEP);
    looks.push(state.angle);
  }
  return looks;
}

let looks: number[][] | undefined;
const path =
  (i: number): Path =>
  (time) =>
    place(i, (looks ??= reference())[Math.round(time * 60)]![i]!);

const ball = (i: number): CaseBody => {
  const angle = i === 0 ? -RAISED : 0;
  return {
    name: `ball ${i + 1}`,
    shape: { type: 'Sphere', radius: RADIUS },
    position: place(i, angle),
    orientation: [0, 0, 1, angle],
  };
};

const balls = Array.from({ length: COUNT }, (_, i) => ball(i));

export const cases: Case[] = [
  {
    id: 'A13',
    name: "Newton's cradle",
    says: `Five balls on rods, ${GAP * 1000} mm apart, bounce 1, the first raised by 30°: the hits go through one after the other. The places of all balls against pendulums that exchange their speeds, in double precision.`,
    scene: {
      gravity: [0, -GRAVITY, 0],
      bodies: balls,
      joints: balls.map(({ name }, i) => ({
        type: 'BallJoint',
        body1: name,
        anchorPoint: anchor(i),
      })),
      contact: { bounce: 1, friction: 0 },
    },
    seconds: SECONDS,
    unit: 'm',
    size: ARM * RAISED,
    singlePrecision: roundingOf(1, SECONDS),
    watch: offPaths(Object.fromEntries(balls.map(({ name }, i) => [name, path(i)]))),
  },
];
