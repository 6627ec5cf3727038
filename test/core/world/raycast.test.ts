import assert from 'node:assert/strict';
import {
  addBody,
  addFloor,
  box,
  claim,
  close,
  fact,
  sphere,
  world,
  type Node,
  type Vec3,
} from '../helpers.js';

const normalize = (v: Vec3): Vec3 => v.map((value) => value / Math.hypot(...v)) as Vec3;

/** Metres. */
const EXACT = 1e-4;

async function lone(geometry: object, fields: object = {}) {
  const w = await world({ gravity: [0, 0, 0] });
  const body = addBody(w, { geometry: [geometry], ...fields });
  const hit = (from: Vec3, to: Vec3, at: Vec3 | null, normal?: Vec3, tolerance = EXACT): void => {
    const found = w.raycast(from, to);
    if (!at) {
      assert.equal(found, null);
      return;
    }
    assert.ok(found, 'it hits');
    assert.ok(found.node === body);
    close(found.position, at, tolerance, 'm');
    const whole = Math.hypot(...to.map((value, i) => value - from[i]!));
    const part = Math.hypot(...at.map((value, i) => value - from[i]!));
    close(found.fraction, part / whole, tolerance / whole + 1e-6);
    if (normal) close(found.normal, normal, 5e-3);
  };
  return { w, body, hit };
}

fact('a ray hits a box on the face it comes to, and misses beside it', async () => {
  const { hit } = await lone(box(2, 4, 6));
  hit([0, 9, 0], [0, -9, 0], [0, 2, 0], [0, 1, 0]);
  hit([0.9, -9, 2.9], [0.9, 9, 2.9], [0.9, -2, 2.9], [0, -1, 0]);
  hit([-9, 1, 2], [9, 1, 2], [-1, 1, 2], [-1, 0, 0]);
  hit([0, 9, 9], [0, -9, -9], [0, 2, 2], [0, 1, 0]);
  hit([1.01, 9, 0], [1.01, -9, 0], null);
  hit([0, 9, 0], [0, 2.01, 0], null);
});

fact('a ray hits a sphere where the quadratic says, along its normal', async () => {
  const { hit } = await lone(sphere(1), { position: [3, 0, 0] });
  for (const offset of [0, 0.3, 0.6, 0.9]) {
    const x = Math.sqrt(1 - offset * offset);
    hit([-5, offset, 0], [9, offset, 0], [3 - x, offset, 0], [-x, offset, 0]);
  }
  hit([-5, 1.01, 0], [9, 1.01, 0], null);
});

fact(
  'a ray meets turned bodies, cylinders and cones, scaled and unevenly scaled shapes',
  async () => {
    const turned = await lone(box(2), { orientation: [0, 0, 1, Math.PI / 4] });
    turned.hit([0, 9, 0], [0, -9, 0], [0, Math.SQRT2, 0]);
    const can = await lone({ type: 'Cylinder', radius: 1, height: 2 });
    can.hit([-9, 0.5, 0.6], [9, 0.5, 0.6], [-0.8, 0.5, 0.6], [-0.8, 0, 0.6]);
    const cone = await lone({ type: 'Cone', bottomRadius: 1, height: 2 });
    cone.hit([-9, 0, 0], [9, 0, 0], [-0.5, 0, 0], [-2 / Math.sqrt(5), 1 / Math.sqrt(5), 0], 0.015);
    const large = await lone({ ...box(1), linear: [3, 0, 0, 0, 2, 0, 0, 0, 1] });
    large.hit([1.4, 9, 0], [1.4, -9, 0], [1.4, 1, 0], [0, 1, 0]);
    const egg = await lone({ ...sphere(1), linear: [2, 0, 0, 0, 1, 0, 0, 0, 1] });
    egg.hit([-9, 0.5, 0], [9, 0.5, 0], [-Math.sqrt(3), 0.5, 0]);
    const sheared = await lone({ ...box(2), linear: [1, 0.5, 0, 0, 1, 0, 0, 0, 1] });
    sheared.hit([-9, 0.5, 0], [9, 0.5, 0], [-0.75, 0.5, 0], normalize([-1, 0.5, 0]));
  },
);

fact('a ray hits the triangles of a fixed mesh from both sides', async () => {
  const slope = {
    type: 'IndexedTriangleSet',
    coord: [-4, -2, -4, 4, 2, -4, 4, 2, 4, -4, -2, 4],
    index: [0, 2, 1, 0, 3, 2],
  };
  const { hit } = await lone(slope, { fixed: true });
  const up: Vec3 = [-1 / Math.sqrt(5), 2 / Math.sqrt(5), 0];
  hit([2, 9, 1], [2, -9, 1], [2, 1, 1], up);
  hit([2, -9, 1], [2, 9, 1], [2, 1, 1], up.map((value) => -value) as Vec3);
});

fact('a ray names the collidable of a compound that it hits', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const shapes = [box(1), sphere(0.5), box(1)].map((shape) =>
    w.add('CollidableShape', { shape: [shape] }),
  );
  const offsets = shapes.map((collidable, i) =>
    w.add('CollidableOffset', { translation: [3 * i, 0, 0], collidable }),
  );
  const body = addBody(w, {
    position: [0, 0, 5],
    orientation: [0, 1, 0, Math.PI / 2],
    centerOfMass: [1, 0, 0],
    geometry: offsets,
  });
  shapes.forEach((shape, i) => {
    const found = w.raycast([0, 9, 5 - 3 * i], [0, -9, 5 - 3 * i]);
    assert.ok(found?.node === body);
    assert.ok(found.collidable === shape);
    close(found.position, [0, 0.5, 5 - 3 * i], EXACT, 'm');
  });
  // Along the row the first one is met first.
  assert.ok(w.raycast([0, 0, 9], [0, 0, -9])?.collidable === shapes[0]);
  assert.ok(w.raycast([0, 0, -9], [0, 0, 9])?.collidable === shapes[2]);
});

fact('the nearest of many is the first hit, over long ways too', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const bodies = [5, 0, -5].map((x) => addBody(w, { position: [x, 0, 0] }));
  for (const far of [10, 100, 10000]) {
    const found = w.raycast([far, 0.3, 0], [-far, 0.3, 0]);
    assert.ok(found?.node === bodies[0]);
    close(found.position, [5.4, 0.3, 0], 1e-4, `m, from ${far} m`);
  }
});

fact('a ray sees edits, jumps and steps at once, before any step and between', async () => {
  const w = await world();
  const ball = addBody(w, { position: [0, 50, 0] });
  const at = (x: number) => w.raycast([x, 100, 0], [x, 0, 0])?.position[1];
  close(at(0)!, 50.5, 1e-3, 'm, before any step');
  ball.teleport([7, 60, 0]);
  assert.equal(at(0), undefined);
  close(at(7)!, 60.5, 1e-3, 'm, after a jump');
  ball.set('geometry', [sphere(2)]);
  close(at(7)!, 62, 1e-3, 'm, grown');
  w.advance(1);
  const height = (ball.get('position') as Vec3)[1];
  close(at(7)!, height + 2, 1e-3, 'm, fallen');
  ball.set('enabled', false);
  assert.equal(at(7), undefined);
  ball.set('enabled', true);
  close(at(7)!, height + 2, 1e-3, 'm, enabled again');
  ball.remove();
  assert.equal(at(7), undefined);
});

fact(
  'a ray hits what sleeps, what collides with nothing, and obstacles, which have no body',
  async () => {
    const w = await world({ rest: 'auto', gravity: [0, 0, 0] });
    claim(w, 'not-in-collider');
    const asleep = addBody(w, { position: [0, 0, 0] });
    const obstacle: Node = w.add('CollidableShape', { shape: [box(1)], translation: [5, 0, 0] });
    w.set('collider', w.add('CollisionCollection', { collidables: [obstacle] }));
    w.advance(3);
    asleep.sleep();
    assert.equal(asleep.sleeping, true);
    assert.ok(w.raycast([0, 9, 0], [0, -9, 0])?.node === asleep);
    assert.equal(asleep.sleeping, true, 'and goes on sleeping');
    const found = w.raycast([5, 9, 0], [5, -9, 0]);
    assert.ok(found?.node === obstacle);
    assert.ok(found.collidable === obstacle);
    close(found.position, [5, 0.5, 0], EXACT, 'm');
  },
);

fact('a ray from inside a body does not see it; one of no length hits nothing', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  addBody(w);
  const next = addBody(w, { position: [3, 0, 0] });
  assert.ok(w.raycast([0, 0, 0], [9, 0, 0])?.node === next);
  assert.equal(w.raycast([3, 0.5, 0], [3, 0.5, 0]), null);
});

fact('points that are none are reported and hit nothing', async () => {
  const w = await world();
  claim(w, 'bad-value');
  addFloor(w);
  for (const [from, to] of [
    [
      [0, NaN, 0],
      [0, -9, 0],
    ],
    [
      [0, 9, 0],
      [0, 1e39, 0],
    ],
    [
      [0, 9],
      [0, -9, 0],
    ],
    [undefined, null],
  ])
    assert.equal(w.raycast(from as Vec3, to as Vec3), null);
});

fact('a world that has cast rays leaves nothing in the heap', async () => {
  const w = await world();
  addBody(w, {
    geometry: [
      sphere(0.5),
      { type: 'CollidableOffset', translation: [2, 0, 0], collidable: box(1) },
    ],
  });
  for (let i = 0; i < 3; i++) {
    assert.ok(w.raycast([2, 9, 0], [2, -9, 0]));
    w.reset();
  }
});
