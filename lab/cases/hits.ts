import { add, scale } from '../../physics-core/base/math.js';
import type { Case, CaseBody, Vec3 } from '../case.js';
import { offPaths, roundingOf, type Path } from './paths.js';

const RADIUS = 0.5;
/** Metres between the two at first. */
const GAP = 1.003;

interface Ball {
  mass: number;
  speed: number;
}

/** Speeds after a hit of two balls. */
function after(a: Ball, b: Ball, bounce: number): [number, number] {
  const both = a.mass + b.mass;
  const apart = bounce * (b.speed - a.speed);
  const common = (a.mass * a.speed + b.mass * b.speed) / both;
  return [common + (b.mass / both) * apart, common - (a.mass / both) * apart];
}

function headOn(id: string, a: Ball, b: Ball, bounce: number): Case {
  const seconds = 1;
  const hit = GAP / (a.speed - b.speed);
  const [speedA, speedB] = after(a, b, bounce);
  const path =
    (start: number, before: number, later: number): Path =>
    (time) => [start + before * Math.min(time, hit) + later * Math.max(0, time - hit), 0, 0];
  const startB = 2 * RADIUS + GAP;
  const body = (name: string, x: number, { mass, speed }: Ball): CaseBody => ({
    name,
    mass,
    shape: { type: 'Sphere', radius: RADIUS },
    position: [x, 0, 0],
    linearVelocity: [speed, 0, 0],
  });
  return {
    id,
    name: `Two balls head-on, bounce ${bounce}`,
    says: `${a.mass} kg at ${a.speed} m/s meets ${b.mass} kg at ${b.speed} m/s, bounce ${bounce}, without weight; the places of both against the speeds that momentum and bounce leave.`,
    scene: {
      gravity: [0, 0, 0],
      bodies: [body('a', 0, a), body('b', startB, b)],
      contact: { bounce, friction: 0 },
    },
    seconds,
    unit: 'm',
    size: 2,
    singlePrecision: roundingOf(2, seconds),
    watch: offPaths({ a: path(0, a.speed, speedA), b: path(startB, b.speed, speedB) }),
  };
}

// ---- oblique ---------------------------------------------------------------------------------------------------------

/** Metres aside of the middle of the ball that it meets. */
const ASIDE = 0.5;

/** Equal balls of 1 kg, bounce 1: what they have along the normal is swapped, and friction turns both. */
function oblique(id: string, friction: number): Case {
  const [speed, seconds, start] = [5, 1.2, -2];
  const across = Math.sqrt(4 * RADIUS ** 2 - ASIDE ** 2);
  const hit = (-across - start) / speed;
  const normal: Vec3 = [-across, ASIDE, 0];
  const push = speed * across;
  // Of each ball 1 + r² / I = 1 + 5 / 2 gives way along the surface, 1/kg.
  const rub = Math.min(friction * push, (speed * ASIDE) / 7);
  const kick = add(scale(normal, push), scale([-ASIDE, -across, 0], rub));
  const from: Vec3 = [start, ASIDE, 0];
  const first: Path = (time) =>
    add(add(from, [speed * time, 0, 0]), scale(kick, Math.max(0, time - hit)));
  const second: Path = (time) => scale(kick, -Math.max(0, time - hit));
  const ball = (name: string, position: Vec3, linearVelocity: Vec3): CaseBody => ({
    name,
    shape: { type: 'Sphere', radius: RADIUS },
    position,
    linearVelocity,
  });
  return {
    id,
    name: `Two balls, obliquely, friction ${friction}`,
    says: `A ball at ${speed} m/s meets one at rest, ${ASIDE} m aside of its middle, bounce 1, friction ${friction}, without weight; the places of both against what momentum, bounce and Coulomb's law leave.`,
    scene: {
      gravity: [0, 0, 0],
      bodies: [ball('a', from, [speed, 0, 0]), ball('b', [0, 0, 0], [0, 0, 0])],
      contact: { bounce: 1, friction },
    },
    seconds,
    unit: 'm',
    size: 4,
    singlePrecision: roundingOf(2, seconds),
    watch: offPaths({ a: first, b: second }),
  };
}

export const cases: Case[] = [
  headOn('hit-bounce-0-5', { mass: 1, speed: 2 }, { mass: 3, speed: -1 }, 0.5),
  headOn('hit-bounce-1', { mass: 5, speed: 4 }, { mass: 1, speed: 0 }, 1),
  oblique('hit-oblique', 0),
  oblique('hit-oblique-rough', 0.3),
  oblique('hit-oblique-slips', 0.05),
];
