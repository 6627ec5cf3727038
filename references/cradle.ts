import { step, type Derivative } from './runge-kutta.js';

/** Balls on rods without mass, which turn with them, side by side in a plane; they collide without loss or friction. */
export interface Cradle {
  count: number;
  /** Metres: of a ball, between two that hang still, and from an anchor to its ball's centre. */
  radius: number;
  gap: number;
  arm: number;
  /** m/s², along -y. */
  gravity: number;
}

/** Angles and rates of all balls, from hanging straight, positive towards +x. */
interface State {
  angle: number[];
  rate: number[];
}

type Point = [x: number, y: number];

/** Where a rod is held, from where the first ball hangs still. */
export const anchorOf = ({ radius, gap, arm }: Cradle, i: number): Point => [
  i * (2 * radius + gap),
  arm,
];

/** Where a ball's centre is. */
export function ballAt(cradle: Cradle, i: number, angle: number): Point {
  const [x, y] = anchorOf(cradle, i);
  return [x + cradle.arm * Math.sin(angle), y - cradle.arm * Math.cos(angle)];
}

/** Each ball by itself. */
function swings({ arm, radius, gravity }: Cradle): (state: State, h: number) => State {
  const pull = (-gravity * arm) / (arm ** 2 + 0.4 * radius ** 2);
  const pendulum: Derivative = ([angle, rate]) => [rate!, pull * Math.sin(angle!)];
  return ({ angle, rate }, h) => {
    const all = angle.map((each, i) => step([each, rate[i]!], h, pendulum));
    return { angle: all.map(([a]) => a!), rate: all.map(([, r]) => r!) };
  };
}

/** Ball i and the next: metres between them, and what each rad/s of theirs is along the line of their centres, m/s. */
function between(cradle: Cradle, { angle }: State, i: number) {
  const [a, b] = [angle[i]!, angle[i + 1]!];
  const [[ax, ay], [bx, by]] = [ballAt(cradle, i, a), ballAt(cradle, i + 1, b)];
  const size = Math.hypot(bx - ax, by - ay);
  const [x, y] = [(bx - ax) / size, (by - ay) / size];
  const lever = (at: number): number => cradle.arm * (x * Math.cos(at) + y * Math.sin(at));
  return { gap: size - 2 * cradle.radius, levers: [lever(a), lever(b)] as const };
}

/** The speed at which they near each other. */
function approach(cradle: Cradle, state: State, i: number): number {
  const { levers } = between(cradle, state, i);
  return state.rate[i]! * levers[0] - state.rate[i + 1]! * levers[1];
}

/** Equal balls: the push between them turns their approach round. */
function strike(cradle: Cradle, state: State, i: number): void {
  const [u, v] = between(cradle, state, i).levers;
  const push = (2 * approach(cradle, state, i)) / (u * u + v * v);
  state.rate[i]! -= push * u;
  state.rate[i + 1]! += push * v;
}

/** Seconds to which the moment of a hit is found. */
const MOMENT = 1e-13;

type Swing = ReturnType<typeof swings>;

/** The seconds, up to `h`, after which ball i and the next meet; Infinity where they do not. */
function meeting(cradle: Cradle, swing: Swing, state: State, i: number, h: number): number {
  const gapAfter = (t: number): number => between(cradle, swing(state, t), i).gap;
  if (gapAfter(h) >= 0 || approach(cradle, state, i) <= 0) return Infinity;
  let [low, high] = [0, h];
  while (high - low > MOMENT) {
    const middle = (low + high) / 2;
    if (gapAfter(middle) > 0) low = middle;
    else high = middle;
  }
  return high;
}

/** On by `h` seconds, hit after hit. */
function advanced(cradle: Cradle, swing: Swing, state: State, h: number): State {
  let [now, left] = [state, h];
  while (left > 0) {
    const times = now.angle.slice(1).map((_, i) => meeting(cradle, swing, now, i, left));
    const first = Math.min(...times);
    if (first === Infinity) return swing(now, left);
    now = swing(now, first);
    strike(cradle, now, times.indexOf(first));
    left -= first;
  }
  return now;
}

/** All angles each 1/60 s, the first ball let go at `raised` radians on its side; `perFrame` steps in 1/60 s. */
export function cradleAngles(
  cradle: Cradle,
  raised: number,
  seconds: number,
  perFrame: number,
): number[][] {
  const swing = swings(cradle);
  const still = new Array<number>(cradle.count).fill(0);
  let state: State = { angle: still.with(0, -raised), rate: still };
  const frames = [state.angle];
  for (let i = 0; i < Math.round(60 * seconds); i++) {
    for (let k = 0; k < perFrame; k++) state = advanced(cradle, swing, state, 1 / 60 / perFrame);
    frames.push(state.angle);
  }
  return frames;
}
