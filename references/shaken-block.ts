/** A block on a plate that goes to and fro: `way` sin(`rate` t). */
export interface ShakenBlock {
  /** Metres. */
  way: number;
  /** rad/s */
  rate: number;
  /** What friction gives it at most, m/s². */
  grip: number;
}

/** A part of its motion: it sticks, or is sped up evenly by friction. */
interface Stretch {
  from: number;
  place: number;
  speed: number;
  /** m/s²; undefined: it sticks. */
  sped?: number;
}

/** Where the block is after so many seconds; it begins with the plate, at its speed. Exact but for roots by bisection. */
export function shakenBlock({ way, rate, grip }: ShakenBlock, seconds: number) {
  const plate = {
    place: (t: number) => way * Math.sin(rate * t),
    speed: (t: number) => way * rate * Math.cos(rate * t),
    sped: (t: number) => -way * rate ** 2 * Math.sin(rate * t),
  };
  const stretches: Stretch[] = [];
  const placeOf = ({ from, place, speed, sped }: Stretch, t: number): number =>
    sped === undefined
      ? place + plate.place(t) - plate.place(from)
      : place + speed * (t - from) + (sped * (t - from) ** 2) / 2;
  let stretch: Stretch = { from: 0, place: 0, speed: plate.speed(0) };
  while (stretch.from < seconds) {
    stretches.push(stretch);
    const { from, speed, sped } = stretch;
    const ends = (t: number): number =>
      sped === undefined
        ? Math.abs(plate.sped(t)) - grip
        : Math.sign(sped) * (speed + sped * (t - from) - plate.speed(t));
    const end = firstAbove(ends, from, seconds);
    const next: Stretch = { from: end, place: placeOf(stretch, end), speed: plate.speed(end) };
    if (Math.abs(plate.sped(end + 1e-9)) > grip) next.sped = Math.sign(plate.sped(end)) * grip;
    stretch = next;
  }
  return (t: number): number => {
    let i = stretches.length - 1;
    while (i > 0 && stretches[i]!.from > t) i--;
    return placeOf(stretches[i]!, t);
  };
}

/** Seconds of looking for a sign that changes. */
const LOOK = 1e-4;

/** When a function that is not positive, or only just begins, first is. */
function firstAbove(f: (t: number) => number, from: number, to: number): number {
  let t = from + LOOK;
  while (f(t) <= 0) {
    if (t > to) return Infinity;
    t += LOOK;
  }
  let before = t - LOOK;
  for (let i = 0; i < 50; i++) {
    const middle = (before + t) / 2;
    if (f(middle) > 0) t = middle;
    else before = middle;
  }
  return t;
}
