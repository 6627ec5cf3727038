import { describe } from 'node:test';
import { subtract } from '../../../../../physics-core/base/math.js';
import { drivenPendulum, pivotAt } from '../../../../../references/driven-pendulum.js';
import type { LevelName } from '../../../../../physics-core/inside.js';
import {
  above,
  addBody,
  addJoint,
  below,
  box,
  close,
  fact,
  position,
  sphere,
  spin,
  velocity,
  WEIGHTLESS,
  world,
  type Vec3,
} from '../../../../core/helpers.js';

const G = 9.8;
const TURN = 2 * Math.PI;

/** How its author moves a pivot: position after so many seconds. */
type Path = (t: number) => Vec3;

interface Swinging {
  accuracy: LevelName;
  path: Path;
  length?: number;
  radius?: number;
  /** Angle from straight below, and velocity, at the start. */
  angle?: number;
  launch?: Vec3;
  joint?: 'BallJoint' | 'SingleAxisHingeJoint';
  /** Who moves it: a listener of each step, or who takes one step after the other. */
  by?: 'listener' | 'caller';
}

/** A ball on a pivot that is moved in each step; `look` is told time, and angle from straight below. */
async function swing(scene: Swinging, seconds: number, look: (t: number, angle: number) => void) {
  const { path, length = 1, angle = 0, radius = 0.1, joint = 'BallJoint' } = scene;
  const w = await world({ accuracy: scene.accuracy });
  const [x, y] = path(0);
  const pivot = addBody(w, { fixed: true, position: path(0), geometry: [box(0.02)] });
  const bob = addBody(w, {
    position: [x + length * Math.sin(angle), y - length * Math.cos(angle), 0],
    geometry: [sphere(radius)],
    linearVelocity: scene.launch ?? [0, 0, 0],
  });
  addJoint(w, joint, {
    body1: bob,
    body2: pivot,
    anchorPoint: path(0),
    ...(joint === 'SingleAxisHingeJoint' && { axis: [0, 0, 1] }),
  });
  w.step(0);
  let n = 0;
  const move = (): void => pivot.set('position', path((n + 1) * w.timeStep));
  if (scene.by !== 'caller') w.on('beforestep', move);
  for (; n < seconds / w.timeStep - 0.5; n++) {
    if (scene.by === 'caller') move();
    w.step();
    const [bx, by] = position(bob);
    const [px, py] = position(pivot);
    look((n + 1) * w.timeStep, Math.atan2(bx - px, py - by));
  }
}

/** Two balls, one below the other, on a pivot that goes up and down by 3 cm nine times a second; where the last one is each 1/60 s. */
async function shakenChain(accuracy: LevelName): Promise<Vec3[]> {
  const w = await world({ accuracy });
  const pivot = addBody(w, { fixed: true, geometry: [box(0.02)] });
  let above = pivot;
  for (const n of [1, 2]) {
    const bob = addBody(w, { position: [0.05 * n, -0.3 * n, 0], geometry: [sphere(0.05)] });
    addJoint(w, 'BallJoint', { body1: bob, body2: above, anchorPoint: position(above) });
    above = bob;
  }
  w.step(0);
  let n = 0;
  w.on('beforestep', () => {
    n++;
    pivot.set('position', [0, 0.03 * Math.sin(9 * TURN * n * w.timeStep), 0]);
  });
  const places: Vec3[] = [];
  for (let frame = 0; frame < 45; frame++) {
    w.step(Math.round(1 / 60 / w.timeStep));
    places.push(position(above));
  }
  return places;
}

/** The angle of a pendulum (a ball of radius .1 on 1 m) whose pivot goes as x = a sin(2π t): fourth order, by steps of 1/960 s. */
function driven(a: number, seconds: number): number[] {
  const inertia = 1 + 0.4 * 0.1 ** 2;
  const pull = (t: number, angle: number): number =>
    -(G * Math.sin(angle) - a * TURN * TURN * Math.sin(TURN * t) * Math.cos(angle)) / inertia;
  const h = 1 / 9600;
  // At rest while the pivot starts at once.
  let [angle, rate] = [0, (-a * TURN) / inertia];
  const angles = [angle];
  for (let i = 0; i < seconds * 9600; i++) {
    const t = i * h;
    const a1 = pull(t, angle);
    const a2 = pull(t + h / 2, angle + (h / 2) * rate);
    const a3 = pull(t + h / 2, angle + (h / 2) * (rate + (h / 2) * a1));
    const a4 = pull(t + h, angle + h * (rate + (h / 2) * a2));
    angle += h * rate + ((h * h) / 6) * (a1 + a2 + a3);
    rate += (h / 6) * (a1 + 2 * a2 + 2 * a3 + a4);
    if (i % 10 === 9) angles.push(angle);
  }
  return angles;
}

describe('pivots that their author moves', () => {
  for (const joint of ['BallJoint', 'SingleAxisHingeJoint'] as const)
    fact(`a pendulum on a ${joint} that is moved to and fro swings as it should`, async () => {
      const exact = driven(0.1, 5);
      for (const [accuracy, bound] of [
        ['game', 1e-3],
        ['standard', 1e-4],
        ['fine', 5e-5],
        ['reference', 5e-5],
      ] as const) {
        let off = 0;
        await swing(
          { accuracy, joint, path: (t) => [0.1 * Math.sin(TURN * t), 0, 0] },
          5,
          (t, angle) => (off = Math.max(off, Math.abs(angle - exact[Math.round(t * 960)]!))),
        );
        below(off, bound, `rad at ${accuracy}`);
      }
    });

  for (const by of ['listener', 'caller'] as const)
    fact(`a pivot at a steady speed is as good as one at rest; moved by a ${by}`, async () => {
      for (const accuracy of ['game', 'standard', 'fine'] as const) {
        const angles: number[] = [];
        const start = { accuracy, angle: 0.5, by };
        await swing({ ...start, path: () => [0, 0, 0] }, 5, (_, angle) => angles.push(angle));
        let off = 0;
        let i = 0;
        await swing({ ...start, path: (t) => [t, 0, 0], launch: [1, 0, 0] }, 5, (_, angle) => {
          off = Math.max(off, Math.abs(angle - angles[i++]!));
        });
        below(off, 2e-5, `rad at ${accuracy}`);
      }
    });

  for (const joint of ['BallJoint', 'SingleAxisHingeJoint'] as const)
    fact(`Kapitza's pendulum on a ${joint} swings about where it stands on its head`, async () => {
      const shaken = {
        arm: 0.4,
        moment: 0.4 ** 2 + 0.4 * 0.1 ** 2,
        way: 0.1,
        gravity: G,
        along: 'y',
        rate: 12 * Math.PI,
        start: Math.PI - 0.3,
      } as const;
      const angleAt = drivenPendulum(shaken, 64);
      for (const [accuracy, bound] of [
        ['game', 5e-2],
        ['standard', 5e-3],
        ['fine', 1e-3],
        ['precise', 3e-4],
        ['reference', 2e-4],
      ] as const) {
        let off = 0;
        const look = (t: number, angle: number): void => {
          const frame = Math.round(t * 60);
          if (Math.abs(frame / 60 - t) > 1e-9) return;
          off = Math.max(off, 2 * Math.abs(Math.sin((angle - angleAt(frame)) / 2)));
        };
        const { arm: length, start: angle } = shaken;
        await swing(
          { accuracy, joint, length, angle, path: (t) => [0, pivotAt(shaken, t), 0] },
          4,
          look,
        );
        below(off, bound, `rad at ${accuracy}`);
      }
    });

  fact('what hangs on what a pivot shakes follows the shaking, too', async () => {
    const [rough, fine] = [await shakenChain('standard'), await shakenChain('reference')];
    const off = rough.map((place, i) => Math.hypot(...subtract(place, fine[i]!)));
    below(Math.max(...off), 4e-4, 'm at standard');
  });

  fact(
    "Kapitza's pendulum stands on its head while its pivot shakes, from standard on",
    async () => {
      // 5 cm at 30 Hz hold up what is shorter than (2π f a)² / 2 g = 4.5 m; 120 steps a second are four a period.
      for (const accuracy of ['standard', 'fine', 'precise', 'reference'] as const) {
        let least = Math.PI;
        await swing(
          {
            accuracy,
            path: (t) => [0, 0.05 * Math.cos(30 * TURN * t), 0],
            length: 0.5,
            radius: 0.02,
            angle: Math.PI - 0.2,
          },
          10,
          (_, angle) => (least = Math.min(least, Math.abs(angle))),
        );
        above(least, Math.PI - 0.25, `rad at ${accuracy}`);
      }
    },
  );

  fact('a pivot that is put elsewhere takes what hangs on it along, at rest', async () => {
    const w = await world();
    const pivot = addBody(w, { fixed: true, geometry: [box(0.1)] });
    const bob = addBody(w, { position: [0, -1, 0], geometry: [sphere(0.1)] });
    const joint = addJoint(w, 'BallJoint', { body1: bob, body2: pivot, anchorPoint: [0, 0, 0] });
    w.advance(0.5);
    pivot.set('position', [0.2, 0.1, 0]);
    w.step();
    below(Math.hypot(...velocity(bob)), 0.1, 'm/s');
    w.step(20);
    below(joint.gap, 1e-5, 'm');
    // It hangs no lower than before, and all it can gain is by falling from there.
    below(Math.hypot(...velocity(bob)), 0.7, 'm/s');
  });

  fact('a pivot that is moved once a frame does not tear what hangs on it', async () => {
    const w = await world({ accuracy: 'fine' });
    const pivot = addBody(w, { fixed: true, geometry: [box(0.1)] });
    const bob = addBody(w, { position: [0, -1, 0], geometry: [sphere(0.1)] });
    const joint = addJoint(w, 'BallJoint', { body1: bob, body2: pivot, anchorPoint: [0, 0, 0] });
    let [gap, off] = [0, 0];
    const exact = driven(0.1, 4);
    for (let frame = 1; frame <= 240; frame++) {
      pivot.set('position', [0.1 * Math.sin((TURN * frame) / 60), 0, 0]);
      w.frame(1 / 60);
      gap = Math.max(gap, joint.gap);
      const [x, y] = position(bob);
      const angle = Math.atan2(x - position(pivot)[0], -y);
      off = Math.max(off, Math.abs(angle - exact[frame * 16]!));
    }
    below(gap, 1e-4, 'm');
    // Of the first frame nobody knows how long it lasts.
    below(off, 0.03, 'rad');
  });

  fact('what slides on a turning base is thrown to its stop, and turns with it', async () => {
    const w = await world(WEIGHTLESS);
    const base = addBody(w, { fixed: true, geometry: [box(0.2)] });
    const arm = addBody(w, { position: [2, 0, 0], geometry: [box(0.2)] });
    const slider = addJoint(w, 'SliderJoint', {
      body1: arm,
      body2: base,
      axis: [1, 0, 0],
      minSeparation: -0.1,
      maxSeparation: 0.1,
    });
    w.step(0);
    let n = 0;
    w.on('beforestep', () => base.set('orientation', [0, 1, 0, ++n * w.timeStep]));
    for (let i = 0; i < 240; i++) {
      w.step();
      below(Math.abs(slider.get('separation') as number), 0.101, 'm, beyond its stop');
    }
    const t = 240 * w.timeStep;
    close(position(arm), [2.1 * Math.cos(t), 0, -2.1 * Math.sin(t)], 2e-3, 'm');
    close(spin(arm), [0, 1, 0], 1e-3, 'rad/s');
  });
});
