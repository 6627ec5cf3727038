import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { createWorld, type Vec3 } from '../../../physics-core/index.js';

const [, boatScene, , bottleScene] = readFileSync('site/recipes/water.md', 'utf8').split('\n## ');

const numbers = (text: string): number[] => text.trim().split(/\s+/).map(Number);

/** What the scene of a page says in an attribute, the n-th time. */
function said(scene: string, attribute: string, n = 0): number[] {
  const [, value] = [...scene.matchAll(new RegExp(` ${attribute}="([-\\d. ]+)"`, 'g'))][n]!;
  return numbers(value!);
}

const sea = (fields: object) => ({
  size: [60, 2, 60] as Vec3,
  position: [0, -1, 0] as Vec3,
  ...fields,
});

/** The boat of the page after it went round for some time: how wide its circle is, metres, and which way it turns. */
async function circle(force: number, liftCoefficient: number): Promise<[number, number]> {
  const world = await createWorld({ console: false });
  world.add('WaterVolume', sea({ damping: 0.2, dragCoefficient: 0.5, liftCoefficient }));
  const boat = world.add('RigidBody', {
    ...{ mass: 170, centerOfMass: said(boatScene!, 'centerOfMass'), position: [0, 0.1, 0] },
    geometry: [
      {
        type: 'IndexedFaceSet',
        coordIndex: said(boatScene!, 'coordIndex'),
        coord: { point: said(boatScene!, 'point') },
      },
    ],
  });
  const plate = world.add('RigidBody', {
    ...{ mass: 8, position: [-1.25, -0.1, 0] },
    geometry: [{ type: 'Box', size: [0.5, 0.5, 0.04] }],
  });
  const [angle] = said(boatScene!, 'minAngle');
  world.add('SingleAxisHingeJoint', {
    ...{ body1: plate, body2: boat, anchorPoint: [-1, 0, 0], axis: [0, 1, 0] },
    ...{ minAngle: angle!, maxAngle: angle! },
  });
  const pose = new Float64Array(7);
  world.on('beforestep', () => {
    const [, , , x, y, z, w] = boat.readPose(pose);
    const ahead = [1 - 2 * (y! * y! + z! * z!), 2 * (x! * y! + w! * z!), 2 * (x! * z! - w! * y!)];
    boat.applyForce(ahead.map((value) => force * value));
  });
  world.advance(20);
  const [rate, speed] = [
    boat.get('angularVelocity')[1]!,
    Math.hypot(...boat.get('linearVelocity')),
  ];
  assert.deepEqual(world.problems, []);
  world.destroy();
  return [(2 * speed) / Math.abs(rate), Math.sign(rate)];
}

test('the boat of the recipe turns in a circle of five metres, astern the other way, and hardly without lift', async () => {
  const [wide, way] = await circle(220, 2);
  assert.ok(Math.abs(wide - 5) < 0.6, `${wide} m`);
  const [, astern] = await circle(-150, 2);
  assert.equal(astern, -way);
  const [wider] = await circle(220, 0);
  assert.ok(wider > 30, `${wider} m`);
});

test('of the two bottles of the recipe that which is heavy below stands, and the other lies', async () => {
  const world = await createWorld({ console: false });
  world.add('WaterVolume', sea({}));
  const [radius, neck] = [said(bottleScene!, 'radius')[0]!, said(bottleScene!, 'radius', 1)[0]!];
  const bottle = (x: number, centerOfMass?: number[]) =>
    world.add('RigidBody', {
      ...{ mass: 20, position: [x, 0.3, 0], orientation: [0, 0, 1, 1.4] },
      ...(centerOfMass && { centerOfMass }),
      geometry: [
        { type: 'Cylinder', radius, height: 0.5 },
        {
          type: 'CollidableShape',
          translation: [0, 0.35, 0],
          shape: { type: 'Cylinder', radius: neck, height: 0.2 },
        },
      ],
    });
  const bottles = [bottle(-0.7, said(bottleScene!, 'centerOfMass')), bottle(0.7)];
  world.advance(10);
  const [stands, lies] = bottles.map((each) => {
    const [, , , x, , z] = each.readPose(new Float64Array(7));
    return 1 - 2 * (x! * x! + z! * z!);
  });
  assert.ok(stands! > 0.99 && lies! < 0.2, `${stands} and ${lies}`);
  world.destroy();
});
