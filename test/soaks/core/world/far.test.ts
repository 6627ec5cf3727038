import assert from 'node:assert/strict';
import { debugLines } from '../../../../physics-core/debug-lines.js';
import { bulletHas } from '../../../../physics-core/inside.js';
import {
  addBody,
  addJoint,
  box,
  claim,
  close,
  codes,
  fact,
  position,
  sphere,
  velocity,
  world,
  type Body,
  type Node,
  type Vec3,
  WEIGHTLESS,
} from '../../../core/helpers.js';

// Far from 0 0 0, where single precision is coarse, all goes as it goes there.

const FAR: Vec3 = [102400, -51200, 204800];

/** Something of everything that has a place, seen from `origin`. */
async function observe(origin: Vec3) {
  const at = (x: number, y: number, z: number): Vec3 => [
    origin[0] + x,
    origin[1] + y,
    origin[2] + z,
  ];
  const near = (place: readonly number[]): number[] => place.map((x, i) => x - origin[i]!);
  const w = await world();
  const saw: unknown[] = [];

  const floor = addBody(w, { fixed: true, position: at(0, -0.5, 0), geometry: [box(40, 1, 40)] });
  const tower = [0.5, 1.5].map((y) => addBody(w, { position: at(0, y, 0), geometry: [box(1)] }));
  const ramp = {
    type: 'IndexedFaceSet',
    coord: { point: [-1, 0, -1, 1, 0, -1, 1, 1, 1, -1, 1, 1] },
    coordIndex: [0, 3, 2, 1, -1],
    solid: false,
  };
  const ramps = addBody(w, {
    fixed: true,
    position: at(4, 0, 0),
    geometry: [{ ...ramp, translation: [0, 0, -3] }, ramp],
  });
  const ball = addBody(w, { position: at(4, 2, 0.5), geometry: [sphere(0.25)] });
  ball.on('collisionstart', (event) => {
    const { contacts } = event as { contacts: { position: Vec3 }[] };
    saw.push(contacts.map(({ position }) => near(position)));
  });

  const link = addBody(w, { position: at(-3, 3, 0), geometry: [box(1, 0.25, 0.25)] });
  const pivot = addJoint(w, 'BallJoint', { body1: link, anchorPoint: at(-3.5, 3, 0) });
  const door = addBody(w, { position: at(-6, 3, 0), geometry: [box(1)] });
  const hinge = addJoint(w, 'SingleAxisHingeJoint', {
    body1: door,
    anchorPoint: at(-6.5, 3, 0),
    axis: [0, 1, 0],
    minAngle: -0.5,
    maxAngle: 0.5,
  });
  const sled = addBody(w, { position: at(-9, 3, 0), geometry: [box(1)] });
  addJoint(w, 'SliderJoint', { body1: sled, axis: [0, 1, 0] });

  const lift = addBody(w, { fixed: true, position: at(8, 1, 0), geometry: [box(2, 0.5, 2)] });
  const rider = addBody(w, { position: at(8, 1.5, 0), geometry: [box(0.5)] });
  const crank = addJoint(w, 'BallJoint', {
    body1: lift,
    body2: addBody(w, { position: at(8, 0.25, 0), mass: 0.5, geometry: [box(0.25)] }),
    anchorPoint: at(8, 0.5, 0),
  });

  const crate = addBody(w, { position: at(0, 2.5, 6), geometry: [box(1)] });
  const drag = crate.drag(at(0.5, 3, 6))!;
  drag.move(at(1, 4, 6));
  const puck = addBody(w, {
    position: at(0, 0.25, -6),
    linearVelocity: [2, 0, 0],
    geometry: [box(0.5)],
  });
  const sensor = w.add('CollisionSensor', {
    collider: w.add('CollisionCollection', { collidables: '*' }),
  });

  const bodies: Body[] = [floor, ...tower, ball, link, door, sled, lift, rider, crate, puck];
  const ends = ramps.get('geometry') as unknown[];
  const contacts = () => sensor.get('contacts') as Node[];
  /** Page code has the puck slide without friction, on points that lie elsewhere. */
  const smooth = () => {
    const given = contacts().filter((contact) => contact.get('body1') === puck);
    for (const contact of given) {
      const [x, y, z] = contact.get('position') as Vec3;
      contact.set('position', [x - 0.0625, y, z]);
      contact.set('frictionCoefficients', [0, 0]);
    }
    if (given.length > 0) w.settings.event('set_contacts', given);
  };
  const all = () => ({
    poses: bodies.map((body) => [...near([...body.pose().p]), ...body.pose().q]),
    read: bodies.map((body) => near([...body.readPose([])].slice(0, 3))),
    centres: bodies.map((body) => near(body.centerOfMassWorld())),
    velocities: bodies.map(velocity),
    anchors: [pivot, hinge, crank].map((joint) => near(joint.get('body1AnchorPoint') as Vec3)),
    contacts: (sensor.get('contacts') as Node[]).map((contact) =>
      near(contact.get('position') as Vec3),
    ),
    parts: contacts().map((contact) =>
      [1, 2].map((i) => ends.indexOf(contact.get(`geometry${i}`))),
    ),
    has: near(bulletHas(door)!['centerOfMass'] as Vec3),
    held: near(drag.point),
    drawn: bodies.map((body) => near([...w.poses.data.slice(7 * body.slot, 7 * body.slot + 3)])),
    ray: [w.raycast(at(0, 9, 0.25), at(0.25, -9, 0)), w.raycast(at(4, 9, 0), at(4.25, -9, 0))].map(
      (hit) => hit && [...near(hit.position), ...hit.normal, hit.fraction],
    ),
  });

  for (let frame = 1; frame <= 60; frame++) {
    lift.set('position', at(8, 1 + frame / 64, 0));
    door.applyForce([0, 0, 1], at(-5.5, 3, 0));
    if (frame === 20) sled.applyImpulse([0, 1, 0], at(-8.5, 3, 0.25));
    if (frame === 30) tower[1]!.teleport(at(0.25, 2, 0.25));
    smooth();
    w.frame(1 / 60);
    if (frame % 20 === 0) saw.push(all());
  }
  const lines = await debugLines(w);
  lines.update();
  saw.push(lines.count);
  const drawn = [...lines.positions.slice(0, 6 * lines.count)];
  saw.push({ lines: drawn.map((x, i) => x - origin[i % 3]!) });
  lines.dispose();
  const kept = w.snapshot();
  w.step(30);
  const after = all();
  w.restore(kept);
  w.step(30);
  saw.push(after, all());
  lift.set('position', at(8, 1, 0));
  w.reset();
  w.step(30);
  saw.push(all());
  return saw;
}

fact('two hundred kilometres from 0 0 0 everything goes as it goes there', async () => {
  const [here, there] = [await observe([0, 0, 0]), await observe(FAR)];
  assert.ok(here.length > 6);
  same(there, here, 'it');
});

/** Lines are drawn in single precision; of anything else double precision loses next to nothing so far away. */
function same(actual: unknown, expected: unknown, where: string): void {
  if (typeof expected === 'number')
    close(actual as number, expected, where.includes('lines') ? 0.05 : 1e-6, where);
  else if (expected && typeof expected === 'object') {
    assert.deepEqual(Object.keys(actual as object), Object.keys(expected), where);
    for (const [key, value] of Object.entries(expected))
      same((actual as Record<string, unknown>)[key], value, `${where}.${key}`);
  } else assert.equal(actual, expected, where);
}

fact('what is pressed hard is told of there as here', async () => {
  const tell = async (gravity: number, [x, y, z]: Vec3) => {
    const w = await world({ accuracy: 'game', gravity: [0, -gravity, 0] });
    addBody(w, { fixed: true, position: [x, y - 0.5, z], geometry: [box(40, 1, 40)] });
    for (let i = 0; i < 10; i++) addBody(w, { position: [x, y + 0.5 + i, z], geometry: [box(1)] });
    w.advance(1);
    claim(w, ...codes(w));
    return codes(w);
  };
  for (const gravity of [1e4, 1e5])
    assert.deepEqual(await tell(gravity, FAR), await tell(gravity, [0, 0, 0]));
});

for (const far of [1e5, -1e5])
  fact(`what moves is served, not what stands: a ball at 0 with a wall at ${far}`, async () => {
    const w = await world(WEIGHTLESS);
    const ball = addBody(w, { linearVelocity: [0.25, 0, 0], geometry: [sphere(0.5)] });
    addBody(w, { fixed: true, position: [far, 0, 0], geometry: [box(1)] });
    w.advance(1);
    close(position(ball), [0.25, 0, 0], 1e-6, 'm');
  });

fact('of two places that bodies are at, the one that is nearer to 0 0 0 counts', async () => {
  const w = await world(WEIGHTLESS);
  addBody(w, { position: [1e5, 0, 0], geometry: [box(1)] });
  addBody(w, { position: [0, 5, 0], geometry: [box(1)] });
  w.step();
  assert.deepEqual([...w.poses.origin], [0, 0, 0]);
});

fact('what goes back to a snapshot counts from where that did', async () => {
  const w = await world(WEIGHTLESS);
  const ball = addBody(w, { linearVelocity: [0.25, 0, 0], geometry: [sphere(0.5)] });
  w.step();
  const kept = w.snapshot();
  for (const y of [0, 5, 10]) addBody(w, { position: [1e5, y, 0], geometry: [box(1)] });
  w.step();
  w.restore(kept);
  const from = position(ball)[0];
  w.advance(1);
  close(position(ball)[0] - from, 0.25, 1e-6, 'm');
});

fact('bodies that stand where their collidables say have them in the middle, too', async () => {
  const w = await world(WEIGHTLESS);
  const stones = [0, 2, 4].map((y) =>
    addBody(w, {
      linearVelocity: [0.25, 0, 0],
      geometry: [
        {
          type: 'CollidableShape',
          translation: [1e6, y, 0],
          shape: [box(1)],
        },
      ],
    }),
  );
  w.advance(1);
  for (const stone of stones) close(position(stone)[0] - 1e6, 0.25, 1e-5, 'm');
});
