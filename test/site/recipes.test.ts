import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { createWorld } from '../../physics-core/index.js';

interface Suspension {
  suspensionErrorCorrection: number;
  suspensionForce: number;
  sag: number;
}

/** The function that the page gives to its readers. */
function suspensionOfThePage(): (mass: number, frequency: number, damping: number) => Suspension {
  const [, code] = readFileSync('site/recipes/car.md', 'utf8').match(
    /```js\n(function suspension[^]*?\n\})/,
  )!;
  return new Function(`return ${code}`)();
}

const SIZE: [number, number, number] = [1, 0.3, 1];
const GEOMETRY = { type: 'Box' as const, size: SIZE };

test('a car on the suspension of the recipe sinks as far and swings as often as it says', async () => {
  const MASS = 100;
  const [frequency, damping] = [1.5, 0.3];
  const { sag, ...fields } = suspensionOfThePage()(MASS, frequency, damping);
  const world = await createWorld({ rest: 'never' });
  const wheel = world.add('RigidBody', { fixed: true, geometry: GEOMETRY });
  const car = world.add('RigidBody', { mass: MASS, position: [0, 1, 0], geometry: GEOMETRY });
  world.add('DoubleAxisHingeJoint', {
    ...{ body1: car, body2: wheel, axis1: [0, 1, 0], axis2: [0, 0, 1] },
    ...{ minAngle1: 0, maxAngle1: 0, ...fields },
  });
  const depth = (): number => 1 - car.get('position')[1]!;
  let [deepest, at] = [0, 0];
  for (let time = 0; time < 1; time = world.time) {
    world.step();
    if (depth() > deepest) [deepest, at] = [depth(), world.time];
  }
  const half = 1 / (2 * frequency * Math.sqrt(1 - damping ** 2));
  assert.ok(Math.abs(at - half) < 0.02, `deepest at ${at} s, not ${half} s`);
  world.advance(9);
  assert.ok(Math.abs(depth() - sag) < 0.001, `${depth()} m, not ${sag} m`);
  world.destroy();
});

test('the door of the recipe is at the asked angle within its stops, and stays there', async () => {
  const world = await createWorld();
  const post = world.add('RigidBody', { fixed: true, geometry: GEOMETRY });
  const door = world.add('RigidBody', {
    ...{ mass: 20, position: [0.95, 0, 0] },
    geometry: [{ type: 'Box', size: [1.7, 2.2, 0.08] }],
  });
  const between = { body1: door, body2: post };
  const stops = { minAngle: -1.7, maxAngle: 0 };
  const hinge = world.add('SingleAxisHingeJoint', { ...between, ...stops, axis: [0, 1, 0] });
  const motor = world.add('MotorJoint', { ...between, motor1Axis: [0, 1, 0] });
  world.on('beforestep', () =>
    motor.set('axis1Torque', 80 * (-1.2 - hinge.get('angle')) - 80 * hinge.get('angleRate')),
  );
  world.advance(6);
  assert.ok(Math.abs(hinge.get('angle') + 1.2) < 0.01, `${hinge.get('angle')}`);
  assert.ok(
    door.get('position')[2]! > 0.5,
    'a negative angle about an axis upwards opens it to +z',
  );
  world.destroy();
});

test('the recipe for what is tipped over has 1 for a body that stands, 0 on its side, -1 on its head', async () => {
  const [, code] = readFileSync('site/recipes/tipped.md', 'utf8').match(
    /(function upright[^]*?\n {2}\})/,
  )!;
  type Poser = { readPose(out: number[]): number[] };
  const upright = new Function('pose', `return ${code}`)([]) as (body: Poser) => number;
  const world = await createWorld();
  const body = world.add('RigidBody', { geometry: GEOMETRY });
  for (const [orientation, expected] of [
    [[0, 1, 0, 2], 1],
    [[1, 0, 0, Math.PI / 2], 0],
    [[0, 0, 1, Math.PI], -1],
    [[0, 0, 1, Math.PI / 4], Math.SQRT1_2],
  ] as const) {
    body.teleport([3, 5, 7], [...orientation]);
    world.step(0);
    assert.ok(Math.abs(upright(body) - expected) < 1e-6, `${upright(body)}, not ${expected}`);
  }
  world.destroy();
});
