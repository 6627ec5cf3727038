import { describe } from 'node:test';
import { add, dot, rotate, scale, subtract } from '../../../../../physics-core/base/math.js';
import {
  above,
  addBody,
  below,
  box,
  close,
  fact,
  position,
  spin,
  world,
  type Body,
  type Hinge,
  type Vec3,
} from '../../../../core/helpers.js';
import {
  G,
  addRod,
  hinge,
  quiet,
  GROUND,
  CRANK,
  COUPLER,
  ROCKER,
  addFourBar,
} from '../../../../core/effects/joints/linkages.js';

const widest = (joints: readonly Hinge[]): number => Math.max(...joints.map((joint) => joint.gap));

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
