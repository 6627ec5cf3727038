import assert from 'node:assert/strict';
import { levels } from '../../../../physics-core/dynamics/levels.js';
import {
  addBody,
  addJoint,
  box,
  close,
  fact,
  height,
  position,
  sphere,
  spin,
  velocity,
  world,
  WEIGHTLESS,
} from '../../helpers.js';
import { addSea, G, IDEAL } from './helpers.js';

/** Of a speed, as a share: what is asked. */
const EXACT = 1e-4;

for (const { name: accuracy } of levels)
  fact(`what sinks comes to the speed at which drag carries it, at ${accuracy}`, async () => {
    const w = await world({ accuracy });
    addSea(w, { ...IDEAL, dragCoefficient: 0.5 });
    const volume = (4 / 3) * Math.PI * 0.1 ** 3;
    const ball = addBody(w, { mass: 3000 * volume, position: [0, -5, 0], geometry: [sphere(0.1)] });
    const cube = addBody(w, { mass: 3, position: [5, -5, 0], geometry: [box(0.1)] });
    w.advance(10);
    // ½ ρ C A v² = (m - ρ V) g.
    close(-velocity(ball)[1] / Math.sqrt((2 * 2 * volume * G) / (0.5 * Math.PI * 0.01)), 1, EXACT);
    close(-velocity(cube)[1] / Math.sqrt((2 * 2 * 0.1 * G) / 0.5), 1, EXACT);
  });

for (const { name: accuracy } of levels)
  fact(`with linear drag alone it sinks as Stokes has it, at ${accuracy}`, async () => {
    const w = await world({ accuracy });
    addSea(w, { ...IDEAL, damping: 4 });
    const cube = addBody(w, { mass: 2, position: [0, -5, 0], geometry: [box(0.1)] });
    w.advance(8);
    // damping × the displaced mass × v = (m - ρ V) g.
    close(-velocity(cube)[1] / (G / 4), 1, EXACT);
  });

fact('drag alone slows down by 1 / (1 + k v t), whatever the step', async () => {
  for (const accuracy of ['game', 'precise'] as const) {
    const w = await world({ accuracy, ...WEIGHTLESS });
    addSea(w, { ...IDEAL, dragCoefficient: 1 });
    const cube = addBody(w, {
      mass: 10,
      position: [0, -50, 0],
      linearVelocity: [8, 0, 0],
      geometry: [box(0.2)],
    });
    w.advance(2);
    const k = (1000 * 0.04) / 2 / 10;
    close(velocity(cube)[0], 8 / (1 + k * 8 * 2), 1e-4);
  }
});

fact('a river takes along what floats in it, in its own frame', async () => {
  const w = await world();
  addSea(w, { flow: [0, 0, 2], orientation: [0, 1, 0, Math.PI / 2], damping: 1 });
  const raft = addBody(w, { mass: 250, geometry: [box(1, 0.5, 1)] });
  w.advance(20);
  const [x, , z] = velocity(raft);
  close(x, 2, EXACT);
  close(z, 0, EXACT);
});

fact('a plate that goes aslant is pushed aside, and lift takes no energy', async () => {
  const w = await world(WEIGHTLESS);
  addSea(w, { ...IDEAL, liftCoefficient: 1 });
  const plate = addBody(w, {
    mass: 100,
    position: [0, -50, 0],
    orientation: [0, 0, 1, 0.3],
    linearVelocity: [2, 0, 0],
    geometry: [box(1, 0.05, 1)],
  });
  const energy = (): number => {
    const [u, v, a] = [velocity(plate), spin(plate), (100 / 12) * (1 + 0.05 ** 2)];
    return 50 * (u[0] ** 2 + u[1] ** 2) + (a / 2) * v[2] ** 2;
  };
  w.advance(0.1);
  // Its lower face looks ahead and down: it is pushed back from there, upward.
  assert.ok(velocity(plate)[1] > 0.1, String(velocity(plate)));
  const before = energy();
  w.advance(1);
  assert.ok(energy() <= before + 1e-3 && energy() > 0.97 * before, `${energy()} of ${before}`);
});

fact(
  'added mass: a ball that is let go in deep water speeds up as if half of that went along',
  async () => {
    const w = await world();
    addSea(w, { ...IDEAL, addedMass: 0.5 });
    const volume = (4 / 3) * Math.PI * 0.1 ** 3;
    const ball = addBody(w, {
      mass: 200 * volume,
      position: [0, -100, 0],
      geometry: [sphere(0.1)],
    });
    w.advance(0.5);
    close(velocity(ball)[1] / ((0.5 * G * 800) / (200 + 500)), 1, EXACT);
  },
);

fact(
  'what is a thousand times lighter than water, or heavier, neither explodes nor leaps beyond bounds',
  async () => {
    for (const accuracy of ['game', 'standard'] as const)
      for (const density of [1, 20, 1e6]) {
        const w = await world({ accuracy });
        addSea(w);
        const ball = addBody(w, {
          mass: density * (4 / 3) * Math.PI * 0.05 ** 3,
          position: [0, 3, 0],
          geometry: [sphere(0.05)],
        });
        const cube = addBody(w, {
          mass: density * 0.001,
          position: [3, 3, 0],
          geometry: [box(0.1)],
        });
        let fastest = 0;
        for (let i = 0; i < 10 / w.timeStep; i++) {
          w.step();
          fastest = Math.max(fastest, Math.hypot(...velocity(ball)), Math.hypot(...velocity(cube)));
        }
        // Nothing falls here faster than from three metres, but for what sinks like a stone.
        if (density < 1e6) assert.ok(fastest < 12, `${density}: ${fastest} m/s`);
        if (density < 1e6) close(height(cube), 0.05, 0.01);
      }
  },
);

fact('a buoy that is held below pulls by what it lacks in weight', async () => {
  const w = await world();
  addSea(w);
  const buoy = addBody(w, { mass: 100, position: [0, -5, 0], geometry: [sphere(0.5)] });
  const joint = addJoint(w, 'BallJoint', {
    body1: buoy,
    anchorPoint: [0, -6, 0],
    forceOutput: 'ALL',
  });
  w.advance(2);
  close(height(buoy), -5, 1e-4);
  assert.ok(joint);
});

fact('with gravity another way water lies another way', async () => {
  const w = await world({ gravity: [-G, 0, 0] });
  w.add('WaterVolume', {
    size: [100, 100, 100],
    orientation: [0, 0, 1, -Math.PI / 2],
    position: [-50, 0, 0],
    damping: 4,
  });
  const cube = addBody(w, { mass: 250, position: [0.1, 0, 0], geometry: [box(0.5, 1, 1)] });
  w.advance(10);
  close(position(cube)[0], 0, 1e-4);
  close(position(cube)[1], 0, 1e-4);
});

fact('oil floats on water, and what floats between lies in both', async () => {
  const w = await world();
  addSea(w, { damping: 4 });
  w.add('WaterVolume', { size: [100, 60, 100], position: [0, -29, 0], density: 800, damping: 4 });
  const cube = addBody(w, {
    mass: 0.9 * 1000,
    position: [0, 0.3, 0],
    geometry: [box(1)],
    centerOfMass: [0, -0.5, 0],
  });
  w.advance(20);
  // 900 = 1000 s + 800 (1 - s): half of it in each, its middle at the water's surface.
  close(height(cube), 0, 1e-5);
});

fact('a volume that rises lifts what floats in it', async () => {
  const w = await world();
  const sea = addSea(w, { damping: 4 });
  const raft = addBody(w, { mass: 250, geometry: [box(1, 0.5, 1)] });
  w.advance(4);
  for (let i = 1; i <= 240; i++) {
    sea.set('position', [0, -200 + i / 240, 0]);
    w.step();
  }
  w.advance(8);
  close(height(raft), 1, 1e-4);
});

fact('below its bottom, beside it, and where it is switched off there is no water', async () => {
  const w = await world();
  const pool = w.add('WaterVolume', { size: [4, 2, 4], position: [0, -1, 0], ...IDEAL });
  const below = addBody(w, { mass: 1, position: [0, -4, 0], geometry: [box(0.5)] });
  const beside = addBody(w, { mass: 1, position: [6, -1, 0], geometry: [box(0.5)] });
  const within = addBody(w, { mass: 1, position: [0, -1, 0], geometry: [box(0.2)] });
  w.step(10);
  const fallen = (G / 2) * (10 * w.timeStep) ** 2;
  close(height(below), -4 - fallen, 1e-5);
  close(height(beside), -1 - fallen, 1e-5);
  assert.ok(height(within) > -1);
  pool.set('enabled', false);
  const before = velocity(within)[1];
  w.step(10);
  close(velocity(within)[1], before - G * 10 * w.timeStep, 1e-4);
});

/** Of what goes slowly from one water into the next, the most by which it goes up or down, metres. */
async function crossed(waters: readonly Record<string, unknown>[]): Promise<number> {
  const w = await world();
  for (const fields of waters) w.add('WaterVolume', fields);
  const cube = addBody(w, { mass: 1000, position: [-1.5, 0, 0], geometry: [box(2, 1, 1)] });
  let most = 0;
  for (let x = -1.5; x < 1.5; x += 0.002) {
    cube.teleport([x, height(cube), 0], [0, 1, 0, 0]);
    w.step();
    most = Math.max(most, Math.abs(height(cube)));
  }
  return most;
}

fact('from one water into the next it stays as high, whether they touch or overlap', async () => {
  for (const over of [0, 0.5, 4])
    for (const order of [1, -1]) {
      const at = (x: number) => ({ size: [10 + over, 4, 10], position: [x, -2, 0] });
      close(await crossed([at(-5 * order), at(5 * order)]), 0, 1e-3);
    }
});

fact('a pool that lies in a denser one gives way to it only there', async () => {
  const w = await world();
  w.add('WaterVolume', { size: [40, 10, 40], position: [0, -5, 0], damping: 4 });
  w.add('WaterVolume', { size: [4, 8, 4], position: [0, -5, 0], density: 2000, damping: 4 });
  const [above, beside] = [0, 10].map((x) =>
    addBody(w, {
      mass: 1500,
      position: [x, -1, 0],
      geometry: [box(1)],
      centerOfMass: [0, -0.5, 0],
    }),
  );
  w.advance(1.5);
  // 1500 = 2000 s + 1000 (1 - s): half of it is in the denser one, whose surface is at -1.
  close(height(above!), -1, 1e-3);
  assert.ok(height(beside!) < -2);
});
