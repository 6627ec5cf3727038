import assert from 'node:assert/strict';
import { describe } from 'node:test';
import { levels, type World } from '../../../../physics-core/inside.js';
import { quaternionOf, rotate } from '../../../../physics-core/base/math.js';
import {
  addBody,
  below,
  box,
  close,
  distance,
  fact,
  position,
  sphere,
  velocity,
  way,
  world,
  type Body,
  type Vec3,
  WEIGHTLESS,
} from '../../helpers.js';

// What nothing touches goes where gravity, its author's forces and damping take it: at every level, to rounding.

/** Metres: 12 m in single precision, rounded 2000 times. */
const ROUNDING = 4e-4;

const eachLevel = (name: string, run: (accuracy: string) => Promise<void>): void => {
  for (const level of levels) fact(`${name} at ${level.name}`, () => run(level.name));
};

/** Where a point of the body is. */
const point = (body: Body, at: Vec3): Vec3 => {
  const [x, y, z, ...q] = body.readPose(new Float64Array(7)) as unknown as number[];
  const [a, b, c] = rotate(q as [number, number, number, number], at);
  return [x! + a, y! + b, z! + c];
};

describe('free flight', () => {
  eachLevel('x₀ + v t + ½ g t², and v + g t', async (accuracy) => {
    const w = await world({ accuracy });
    const ball = addBody(w, { linearVelocity: [3, 8, 1] });
    w.advance(2);
    close(position(ball), [6, 16 - way(9.8, 2), 2], ROUNDING, 'm');
    close(velocity(ball), [3, 8 - 19.6, 1], 3e-4, 'm/s');
  });

  eachLevel('½ a t² under a steady force, ½ α t² under a steady torque', async (accuracy) => {
    const w = await world({ accuracy, ...WEIGHTLESS });
    const ball = addBody(w, { mass: 2, forces: [[4, 0, -2]], torques: [[0, 0, 0.1]] });
    w.advance(2);
    close(position(ball), [way(2, 2), 0, -way(1, 2)], ROUNDING, 'm');
    const turn = quaternionOf([0, 0, 1, way(0.1 / 0.2, 2)]);
    const end = point(ball, [1, 0, 0]).map((x, i) => x - position(ball)[i]!);
    close(end, rotate(turn, [1, 0, 0]), ROUNDING, 'm, of 1 m');
  });

  eachLevel('v = g/k + (v₀ - g/k) e^(-k t) under damping', async (accuracy) => {
    const w = await world({ accuracy });
    const ball = addBody(w, {
      mass: 2,
      linearVelocity: [3, 8, 1],
      angularVelocity: [0, 2, 0],
      autoDamp: true,
      linearDampingFactor: 0.8,
      angularDampingFactor: 0.1,
    });
    w.advance(2);
    const lost = (1 - Math.exp(-0.8)) / 0.4;
    const fallen = (9.8 * (2 - lost)) / 0.4;
    close(position(ball), [3 * lost, 8 * lost - fallen, lost], ROUNDING, 'm');
    const left = Math.exp(-0.8);
    close(velocity(ball)[1], 8 * left - 9.8 * lost, 2e-4, 'm/s');
    // 0.2 kg·m²: half of the spin is lost per second and e-fold.
    const turn = quaternionOf([0, 1, 0, (2 * (1 - Math.exp(-0.5 * 2))) / 0.5]);
    const end = point(ball, [1, 0, 0]).map((x, i) => x - position(ball)[i]!);
    close(end, rotate(turn, [1, 0, 0]), ROUNDING, 'm, of 1 m');
  });

  eachLevel(
    'edits, impulses and leaps in mid-flight count from when they come',
    async (accuracy) => {
      const w = await world({ accuracy });
      const ball = addBody(w, { linearVelocity: [0, 5, 0] });
      w.advance(0.5);
      let [v, y] = [5 - 4.9, 2.5 - way(9.8, 0.5)];
      close(position(ball)[1], y, ROUNDING, 'm, thrown');

      ball.set('linearVelocity', [1, 3, 0]);
      w.advance(0.5);
      [v, y] = [3 - 4.9, y + 1.5 - way(9.8, 0.5)];
      close(position(ball), [0.5, y, 0], ROUNDING, 'm, thrown again');

      w.set('gravity', [0, 3, 0]);
      w.advance(0.5);
      [v, y] = [v + 1.5, y + v * 0.5 + way(3, 0.5)];
      close(position(ball), [1, y, 0], ROUNDING, 'm, under another gravity');

      ball.applyImpulse([0, 2, 0]);
      w.advance(0.5);
      [v, y] = [v + 2 + 1.5, y + (v + 2) * 0.5 + way(3, 0.5)];
      close(position(ball), [1.5, y, 0], ROUNDING, 'm, after a blow');

      ball.teleport([0, 7, 0]);
      w.set('accuracy', accuracy === 'game' ? 'reference' : 'game');
      w.advance(0.5);
      close(
        position(ball),
        [0.5, 7 + v * 0.5 + way(3, 0.5), 0],
        ROUNDING,
        'm, elsewhere, by other steps',
      );
    },
  );

  eachLevel('a ball lets go of what throws it and flies on exactly', async (accuracy) => {
    const w = await world({ accuracy });
    const ball = addBody(w, {
      position: [1, 0, 0],
      angularVelocity: [0, 0, 5],
      linearVelocity: [0, 5, 0],
    });
    const joint = w.add('BallJoint', { body1: ball });
    w.advance(0.25);
    joint.remove();
    w.step();
    const [from, speed] = [position(ball), velocity(ball)];
    w.advance(1);
    const expected = from.map((x, i) => x + speed[i]! - (i === 1 ? way(9.8, 1) : 0));
    close(position(ball), expected, ROUNDING, 'm');
  });

  fact('a snapshot in mid-flight goes on bit for bit', async () => {
    const w = await world();
    const balls = [0, 1, 2].map((x) =>
      addBody(w, {
        position: [3 * x, 0, 0],
        linearVelocity: [x, 4, 0],
        forces: x ? [[0, x, 1]] : [],
        torques: [[0, x / 10, 0]],
        autoDamp: x === 2,
      }),
    );
    w.advance(0.3);
    const kept = w.snapshot();
    const onward = (): number[] => {
      w.advance(0.7);
      return balls.flatMap((ball) => [...ball.readPose(new Float64Array(7)), ...velocity(ball)]);
    };
    const first = onward();
    w.restore(kept);
    close(onward(), first, 0, 'm');
  });
});

/** Swings of 1 kg that page code pulls back with k = 100 N/m, looked at after many. */
async function sprung(pull: (ball: Body, force: Vec3, w: World) => void): Promise<number> {
  const w = await world();
  const ball = addBody(w, { position: [0, 0.098 * -1, 0], linearVelocity: [1, 0, 0] });
  w.on('beforestep', () => pull(ball, position(ball).map((x) => -100 * x) as Vec3, w));
  let most = 0;
  for (let i = 0; i < 2400; i++) {
    w.step();
    if (i > 2000) most = Math.max(most, Math.hypot(position(ball)[0], position(ball)[1] + 0.098));
  }
  return most;
}

describe('a spring made by page code', () => {
  fact('keeps its swing over 20 s by applyForce', async () => {
    close(await sprung((ball, force) => ball.applyForce(force)), 0.1, 0.006, 'm');
  });
  fact('keeps its swing over 20 s by forces', async () => {
    close(await sprung((ball, force) => ball.set('forces', [force])), 0.1, 0.006, 'm');
  });
});

describe('what something touches', () => {
  for (const accuracy of ['game', 'standard', 'precise']) {
    fact(`rests where it rested before, at ${accuracy}`, async () => {
      const w = await world({ accuracy });
      addBody(w, { fixed: true, position: [0, -0.5, 0], geometry: [box(10, 1, 10)] });
      const bodies = [box(1), sphere(0.5)].map((shape, i) =>
        addBody(w, { position: [3 * i, 0.5, 0], geometry: [shape] }),
      );
      w.advance(2);
      for (const body of bodies) {
        close(position(body)[1], 0.5, 5e-4, 'm');
        below(distance(velocity(body), [0, 0, 0]), 1e-3, 'm/s');
      }
    });
  }
});

fact('a torque on unequal moments alone is none of its business', async () => {
  const w = await world(WEIGHTLESS);
  addBody(w, { geometry: [box(1, 2, 3)], torques: [[1, 0, 0]] });
  w.step();
  const on = w.effects.filter(({ active }) => active).map(({ name }) => name);
  assert.deepEqual(on, ['forces', 'gyroscopic torque']);
});
