import { describe } from 'node:test';
import {
  add,
  compose,
  conjugate,
  dot,
  rotate,
  scale,
  subtract,
} from '../../physics-core/base/math.js';
import type { World } from '../../physics-core/inside.js';
import {
  above,
  addBody,
  addJoint,
  below,
  box,
  close,
  fact,
  position,
  spin,
  velocity,
  world,
  type Body,
  type Hinge,
  type Vec3,
} from './helpers.js';

const G = 9.8;

/** A thin rod of 1 kg between two points in the plane of x and y; it turns about the first, rad/s. */
function addRod(w: World, from: Vec3, to: Vec3, turning = 0): Body {
  const along = subtract(to, from);
  return addBody(w, {
    angularVelocity: [0, 0, turning],
    linearVelocity: scale([-along[1], along[0], 0], turning / 2),
    position: scale(add(from, to), 0.5),
    orientation: [0, 0, 1, Math.atan2(along[1], along[0])],
    geometry: [box(Math.hypot(...along), 0.02, 0.02)],
  });
}

const hinge = (w: World, at: Vec3, body1: Body, body2?: Body, axis: Vec3 = [0, 0, 1]): Hinge =>
  addJoint(w, 'SingleAxisHingeJoint', { body1, ...(body2 && { body2 }), axis, anchorPoint: at });

/** Nothing collides: only joints count. */
const quiet = (w: World): void =>
  void w.add('CollisionCollection', { collidables: '*', enabled: false });

const widest = (joints: readonly Hinge[]): number => Math.max(...joints.map((joint) => joint.gap));

const height = (body: Body): number => body.centerOfMassWorld()[1];

/** Kinetic energy at a velocity and a spin (world), joules. */
function kinetic(body: Body, v: Vec3, turning: Vec3): number {
  const { mass, moments } = body.mass;
  const w = rotate(conjugate(compose(body.pose(), body.centerOfMass).q), turning);
  return (mass * dot(v, v) + moments.reduce((sum, moment, x) => sum + moment * w[x]! ** 2, 0)) / 2;
}

/**
 * Highest and lowest energy on the way, less that of the start, over `range`. The velocity of jointed bodies belongs to
 * the middle of the step: at a pose it is the mean of the steps before and after.
 */
function energyBand(w: World, bodies: Body[], seconds: number, range: number): [number, number] {
  const before = bodies.map((body) => ({ y: height(body), v: velocity(body), spin: spin(body) }));
  const total = (): number =>
    bodies.reduce((sum, body, i) => {
      const { y, v, spin: turning } = before[i]!;
      const mean = (a: Vec3, b: Vec3) => scale(add(a, b), 0.5);
      const moving = kinetic(body, mean(v, velocity(body)), mean(turning, spin(body)));
      before[i] = { y: height(body), v: velocity(body), spin: spin(body) };
      return sum + body.mass.mass * G * y + moving;
    }, 0);
  const start = bodies.reduce((sum, body) => sum + body.mass.mass * G * height(body), 0);
  let [most, least] = [start, start];
  w.step();
  total();
  for (let i = 1; i < seconds / w.timeStep; i++) {
    w.step();
    const now = total();
    most = Math.max(most, now);
    least = Math.min(least, now);
  }
  return [(most - start) / range, (start - least) / range];
}

/** Frictionless systems that start from rest, and the energy (J) that falling to the lowest pose sets free. */
const systems: Record<string, (w: World) => { bodies: Body[]; range: number }> = {
  pendulum(w) {
    const rod = addRod(w, [0, 0, 0], [1, 0, 0]);
    hinge(w, [0, 0, 0], rod);
    return { bodies: [rod], range: G / 2 };
  },
  'double pendulum'(w) {
    const [one, two] = [addRod(w, [0, 0, 0], [1, 0, 0]), addRod(w, [1, 0, 0], [2, 0, 0])];
    hinge(w, [0, 0, 0], one);
    hinge(w, [1, 0, 0], two, one);
    return { bodies: [one, two], range: 2 * G };
  },
  'four-bar'(w) {
    const { bars } = addFourBar(w);
    // From straight up at the crank to straight down.
    return { bodies: bars, range: G };
  },
};

describe('energy without friction', () => {
  for (const [accuracy, seconds] of [
    ['game', 20],
    ['standard', 20],
    ['fine', 20],
    ['precise', 60],
  ] as const) {
    for (const [name, build] of Object.entries(systems)) {
      fact(
        `${name}: never above its start by 1 %, nor below by 5 %, in ${seconds} s at ${accuracy}`,
        async () => {
          const w = await world({ accuracy });
          quiet(w);
          const { bodies, range } = build(w);
          const [most, least] = energyBand(w, bodies, seconds, range);
          below(most, 0.01, 'of the energy gained');
          below(least, 0.05, 'of the energy lost');
        },
      );
    }
  }
});

// ---- loops -----------------------------------------------------------------------------------------------------------

/** Ground 2 m, crank 1 m, coupler 2 m, rocker 2 m: a crank that goes round. */
const [GROUND, CRANK, COUPLER, ROCKER] = [2, 1, 2, 2];

/** Where the rocker's end is for an angle of the crank: where two circles meet, above. */
function meeting(crank: number): Vec3 {
  const [x, y] = [CRANK * Math.cos(crank), CRANK * Math.sin(crank)];
  const [dx, dy] = [GROUND - x, -y];
  const d = Math.hypot(dx, dy);
  const along = (COUPLER ** 2 - ROCKER ** 2 + d * d) / (2 * d);
  const across = Math.sqrt(COUPLER ** 2 - along ** 2);
  return [x + (dx * along - dy * across) / d, y + (dy * along + dx * across) / d, 0];
}

function addFourBar(w: World): { bars: Body[]; joints: Hinge[] } {
  const [a, b, c, d]: Vec3[] = [[0, 0, 0], [0, 1, 0], meeting(Math.PI / 2), [GROUND, 0, 0]];
  const bars = [addRod(w, a!, b!), addRod(w, b!, c!), addRod(w, d!, c!)];
  const [crank, coupler, rocker] = bars as [Body, Body, Body];
  const joints = [
    hinge(w, a!, crank),
    hinge(w, b!, coupler, crank),
    hinge(w, c!, rocker, coupler),
    hinge(w, d!, rocker),
  ];
  return { bars, joints };
}

/** Direction of a rod's long side in the plane, radians. */
function direction(rod: Body): number {
  const [x, y] = rotate(rod.pose().q, [1, 0, 0]);
  return Math.atan2(y, x);
}

describe('loops', () => {
  for (const [accuracy, bound] of [
    ['standard', 1e-4],
    ['precise', 1e-5],
  ] as const) {
    fact(
      `four-bar: the output follows the crank by Freudenstein's equation at ${accuracy}`,
      async () => {
        const w = await world({ accuracy });
        quiet(w);
        const { bars, joints } = addFourBar(w);
        let [off, gap, turned] = [0, 0, 0];
        for (let i = 0; i < 5 / w.timeStep; i++) {
          w.step();
          const [crank, rocker] = [direction(bars[0]!), direction(bars[2]!)];
          // K₁ cos ψ − K₂ cos φ + K₃ = cos(φ − ψ)
          const [k1, k2] = [GROUND / CRANK, GROUND / ROCKER];
          const k3 = (CRANK ** 2 - COUPLER ** 2 + ROCKER ** 2 + GROUND ** 2) / (2 * CRANK * ROCKER);
          const miss = k1 * Math.cos(rocker) - k2 * Math.cos(crank) + k3 - Math.cos(crank - rocker);
          off = Math.max(off, Math.abs(miss));
          gap = Math.max(gap, widest(joints));
          turned = Math.max(turned, Math.abs(crank - Math.PI / 2));
        }
        below(off, bound, 'of the equation');
        below(gap, bound, 'm');
        above(turned, 1, 'rad, it swung');
      },
    );
  }

  fact("Bricard's loop of six hinges at right angles moves as one, without gaps", async () => {
    const w = await world({ accuracy: 'standard' });
    quiet(w);
    // Six edges of a cube; each hinge stands at right angles to both of its edges.
    const corners: Vec3[] = [
      [1, 0, 0],
      [1, 1, 0],
      [0, 1, 0],
      [0, 1, 1],
      [0, 0, 1],
      [1, 0, 1],
    ];
    const rods = corners.map((from, i) => {
      const to = corners[(i + 1) % 6]!;
      const size = subtract(to, from).map((x) => Math.max(0.05, Math.abs(x)));
      const middle = scale(add(from, to), 0.5);
      return addBody(w, { position: middle, fixed: i === 5, geometry: [box(...size)] });
    });
    const joints = corners.map((at, i) => {
      const [next, before] = [corners[(i + 1) % 6]!, corners[(i + 5) % 6]!];
      const sides = add(subtract(next, at), subtract(before, at)).map(Math.abs);
      const axis = sides.map((x) => +(x < 0.5)) as Vec3;
      return hinge(w, at, rods[i]!, rods[(i + 5) % 6], axis);
    });
    let [gap, off, most] = [0, 0, 0];
    for (let i = 0; i < 10 / w.timeStep; i++) {
      w.step();
      gap = Math.max(gap, widest(joints));
      // cos θ₁ + cos θ₂ + cos θ₁ cos θ₂ = 0 while every second angle is the same: it starts with all at 90°.
      const turns = corners.map((_, k) => {
        const side = (n: number): Vec3 => {
          const rod = rods[n % 6]!;
          const start = subtract(corners[(n + 1) % 6]!, corners[n % 6]!);
          return rotate(rod.pose().q, start);
        };
        return dot(side(k + 5), side(k));
      });
      off = Math.max(
        off,
        Math.abs(turns[0]! + turns[1]! + turns[0]! * turns[1]!),
        Math.abs(turns[0]! - turns[2]!),
        Math.abs(turns[1]! - turns[5]!),
      );
      most = Math.max(most, Math.abs(turns[0]!));
    }
    below(gap, 1e-3, 'm');
    below(off, 1e-3, 'of the loop equation');
    above(most, 0.3, 'it moved');
  });

  fact('slider-crank: x = r cos θ + √(l² − r² sin² θ)', async () => {
    const w = await world({ accuracy: 'standard', gravity: [0, 0, 0] });
    quiet(w);
    const [r, l] = [0.5, 1.5];
    const crank = addRod(w, [0, 0, 0], [r, 0, 0], 10);
    const rod = addRod(w, [r, 0, 0], [r + l, 0, 0]);
    const piston = addBody(w, { position: [r + l, 0, 0], geometry: [box(0.2)] });
    const joints = [
      hinge(w, [0, 0, 0], crank),
      hinge(w, [r, 0, 0], rod, crank),
      hinge(w, [r + l, 0, 0], piston, rod),
    ];
    w.add('SliderJoint', { body1: piston, axis: [1, 0, 0], minSeparation: 1, maxSeparation: 0 });
    let [off, gap, turns] = [0, 0, 0];
    for (let i = 0; i < 5 / w.timeStep; i++) {
      w.step();
      const angle = direction(crank);
      const x = r * Math.cos(angle) + Math.sqrt(l * l - (r * Math.sin(angle)) ** 2);
      off = Math.max(off, Math.abs(position(piston)[0] - x));
      gap = Math.max(gap, widest(joints));
      turns += (spin(crank)[2] * w.timeStep) / (2 * Math.PI);
    }
    below(off, 1e-3, 'm');
    below(gap, 1e-3, 'm');
    above(Math.abs(turns), 2, 'turns');
  });

  fact('a door on four hinges swings as on one, and does not creep', async () => {
    const swing = async (hinges: number): Promise<number> => {
      const w = await world({ accuracy: 'standard', gravity: [0, -G, 2] });
      quiet(w);
      const door = addBody(w, { position: [0.5, 0, 0], geometry: [box(1, 2, 0.05)] });
      const joints = Array.from({ length: hinges }, (_, i) =>
        hinge(w, [0, hinges > 1 ? i * 0.6 - 0.9 : 0, 0], door, undefined, [0, 1, 0]),
      );
      let gap = 0;
      for (let i = 0; i < 20 / w.timeStep; i++) {
        w.step();
        gap = Math.max(gap, widest(joints));
      }
      below(gap, 1e-5, 'm');
      return joints[0]!.angle;
    };
    close(await swing(4), await swing(1), 2e-3, 'rad after 20 s');
  });
});
