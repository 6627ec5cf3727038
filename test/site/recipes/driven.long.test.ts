import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { createWorld, type Vec3 } from '../../../physics-core/index.js';

const page = (name: string): string => readFileSync(`site/recipes/${name}.md`, 'utf8');

const near = (value: number, wanted: number, within: number, what = ''): void =>
  assert.ok(Math.abs(value - wanted) <= within, `${what} ${value}, not ${wanted}`);

const box = (...size: Vec3) => [{ type: 'Box' as const, size }];

/** The way of the lift's page, there and back. */
function wayOfThePage(): (time: number, seconds: number) => number {
  const [, code] = /const way = (.*);/.exec(page('lift'))!;
  return new Function(`return ${code}`)();
}

test('what stands on a platform or in a lift of the recipe goes along, and at its speed', async () => {
  const way = wayOfThePage();
  const world = await createWorld();
  const platform = world.add('RigidBody', { fixed: true, geometry: box(2, 0.2, 2) });
  const cargo = world.add('RigidBody', { position: [0, 0.6, 0], geometry: box(1, 1, 1) });
  const place = (): Vec3 => [3 * way(world.time, 8), 2.5 * way(world.time, 10), 0];
  world.on('beforestep', () => platform.set('position', place()));
  for (const seconds of [2, 2, 2, 2]) {
    world.advance(seconds);
    const [x, y] = cargo.get('position') as Vec3;
    const [toX, toY] = platform.get('position') as Vec3;
    near(x, toX, 0.02, 'along');
    near(y, toY + 0.6, 0.005, 'up');
  }
  world.destroy();
});

test('a platform that starts at once leaves what stands on it behind by v² / 2μg, and no more', async () => {
  const world = await createWorld();
  const platform = world.add('RigidBody', { fixed: true, geometry: box(3, 0.2, 2) });
  const cargo = world.add('RigidBody', { position: [0, 0.6, 0], geometry: box(1, 1, 1) });
  world.on('beforestep', () => platform.set('position', [0.5 * world.time, 0, 0]));
  world.advance(2);
  near((cargo.get('linearVelocity') as Vec3)[0], 0.5, 1e-4, 'm/s');
  const behind = (platform.get('position') as Vec3)[0] - (cargo.get('position') as Vec3)[0];
  near(behind, 0.5 ** 2 / (2 * 0.5 * 9.8), 0.005, 'm behind');
  world.destroy();
});

test('the mill of the recipe turns at the speed that is asked, and gives way where its torque does not do', async () => {
  for (const [most, wanted] of [
    [400, 2],
    [100, 0],
  ] as const) {
    const world = await createWorld();
    const arm = world.add('RigidBody', { mass: 20, geometry: box(4, 0.16, 0.8) });
    // 10 kg at two metres from the axle: 196 N m.
    const load = world.add('RigidBody', {
      mass: 10,
      position: [2, 0, 0],
      geometry: box(0.2, 0.2, 0.2),
    });
    const hinge = {
      axis1: [0, 1, 0] as Vec3,
      axis2: [0, 0, 1] as Vec3,
      minAngle1: 0,
      maxAngle1: 0,
    };
    world.add('DoubleAxisHingeJoint', {
      ...{ body1: arm, ...hinge, desiredAngularVelocity2: 2, maxTorque2: most },
    });
    world.add('UniversalJoint', {
      body1: arm,
      body2: load,
      anchorPoint: [2, 0, 0],
      axis1: [1, 0, 0],
      axis2: [0, 1, 0],
    });
    world.advance(1);
    const rate = (arm.get('angularVelocity') as Vec3)[2];
    if (wanted) near(rate, wanted, 0.01, 'rad/s');
    else assert.ok(rate < 0.5, `${rate} rad/s`);
    world.destroy();
  }
});

test('the motor of the recipe brings a hinge to its speed with a guess of the moment that is three times off', async () => {
  for (const guess of [1 / 3, 1, 3]) {
    const world = await createWorld();
    const rotor = world.add('RigidBody', { mass: 5, geometry: box(2, 0.2, 0.2) });
    const hinge = world.add('SingleAxisHingeJoint', { body1: rotor, axis: [0, 0, 1] });
    const motor = world.add('MotorJoint', { body1: rotor, motor1Axis: [0, 0, 1] });
    const moment = (guess * 5 * (2 ** 2 + 0.2 ** 2)) / 12;
    world.on('beforestep', () => {
      const torque = (0.5 * moment * (2 - hinge.get('angleRate'))) / world.timeStep;
      motor.set('axis1Torque', Math.max(-400, Math.min(400, torque)));
    });
    world.advance(0.5);
    near(hinge.get('angleRate'), 2, 0.001, 'rad/s');
    world.destroy();
  }
});

interface Rolling {
  mass: number;
  radius: number;
}

/** The function that the page gives to its readers. */
function resistOfThePage(): (ball: object, of: Rolling) => void {
  const [, code] = /(function resist[^]*?\n {2}\})/.exec(page('rolling'))!;
  return new Function(`return ${code}`)();
}

test('the slowed ball of the recipe comes to rest as far as the page says', async () => {
  const resist = resistOfThePage();
  const world = await createWorld();
  world.add('RigidBody', { fixed: true, position: [0, -0.5, 0], geometry: box(60, 1, 4) });
  const rolling = { mass: 2, radius: 0.4 };
  const ball = world.add('RigidBody', {
    ...{ mass: rolling.mass, position: [0, 0.4, 0], linearVelocity: [2, 0, 0] },
    ...{ angularVelocity: [0, 0, -5], geometry: [{ type: 'Sphere', radius: 0.4 }] },
  });
  const element = {
    world,
    get angularVelocity() {
      return ball.get('angularVelocity');
    },
    applyTorque: (torque: Vec3) => ball.applyTorque(torque),
  };
  world.on('beforestep', () => resist(element, rolling));
  world.advance(12);
  const [x] = ball.get('position') as Vec3;
  near(x, 2 ** 2 / (2 * (5 / 7) * 0.05 * 9.8), 0.05, 'm');
  near(x, 5.7, 0.05, 'm on the page');
  assert.ok(Math.hypot(...(ball.get('linearVelocity') as Vec3)) < 0.001);
  world.destroy();
});

test('a marble that bounces in the tray touches it several times, and a set has it once', async () => {
  const world = await createWorld();
  const collidables = { collidables: '*' as const, appliedParameters: ['BOUNCE' as const] };
  world.add('CollisionCollection', { ...collidables, bounce: 0.5 });
  const tray = world.add('RigidBody', { fixed: true, geometry: box(4, 0.2, 4) });
  for (const x of [-1, 0, 1])
    world.add('RigidBody', { position: [x, 2, 0], geometry: [{ type: 'Sphere', radius: 0.18 }] });
  const counted = new Set<unknown>();
  let touches = 0;
  tray.on('collisionstart', ({ other }) => {
    counted.add(other);
    touches++;
  });
  world.advance(3);
  assert.equal(counted.size, 3);
  assert.ok(touches > 6, `${touches} touches`);
  world.destroy();
});

test('a recording is gone on from with the same bits', async () => {
  const world = await createWorld();
  world.add('RigidBody', { fixed: true, position: [0, -0.5, 0], geometry: box(20, 1, 20) });
  const boxes = [0.35, 1.05, 1.75].map((y) =>
    world.add('RigidBody', { position: [1.2, y, 0], geometry: box(0.7, 0.7, 0.7) }),
  );
  const ball = [{ type: 'Sphere' as const, radius: 0.4 }];
  world.add('RigidBody', {
    mass: 2,
    position: [-3, 1, 0.1],
    linearVelocity: [8, 2, 0],
    geometry: ball,
  });
  const recorded = [];
  for (let i = 0; i < 60; i++) {
    recorded.push(world.snapshot());
    world.step(4);
  }
  const poses = (): unknown => boxes.map((each) => [each.get('position'), each.get('orientation')]);
  const end = poses();
  world.restore(recorded[20]!);
  world.step(4 * 40);
  assert.deepEqual(poses(), end);
  world.destroy();
});

test('a ball comes to rest on the terrain of the recipe, in a valley of its heights', async () => {
  const [, text] = /height="([^"]+)"/.exec(page('terrain'))!;
  const height = text!.trim().split(/\s+/).map(Number);
  const across = Math.sqrt(height.length);
  const world = await createWorld();
  world.add('RigidBody', {
    fixed: true,
    position: [-8, 0, -8],
    geometry: [
      {
        ...{ type: 'ElevationGrid', height, xDimension: across, zDimension: across },
        ...{ xSpacing: 1, zSpacing: 1 },
      },
    ],
  });
  const ball = world.add('RigidBody', {
    ...{ position: [-5, 4.5, -3], autoDamp: true, angularDampingFactor: 0.5 },
    geometry: [{ type: 'Sphere', radius: 0.4 }],
  });
  world.advance(20);
  const [x, y, z] = ball.get('position') as Vec3;
  const around = [Math.floor(x + 8), Math.ceil(x + 8)].flatMap((i) =>
    [Math.floor(z + 8), Math.ceil(z + 8)].map((k) => height[k * across + i]!),
  );
  assert.ok(
    y > Math.min(...around) + 0.35 && y < Math.max(...around) + 0.6,
    `${y} above ${around}`,
  );
  assert.deepEqual(world.problems, []);
  world.destroy();
});
