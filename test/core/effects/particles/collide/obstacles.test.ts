import assert from 'node:assert/strict';
import {
  MET,
  METS,
  Obstacles,
} from '../../../../../physics-core/effects/particles/collide/obstacles.js';
import { BOX, type Search } from '../../../../../physics-core/effects/particles/collide/slabs.js';
import type { World } from '../../../../../physics-core/inside.js';
import { rotationOf } from '../../../../../physics-core/base/math.js';
import { POSE } from '../../../../../physics-core/dynamics/poses.js';
import {
  addBody,
  addFloor,
  box,
  claim,
  close,
  fact,
  random,
  sphere,
  WEIGHTLESS,
  world,
  type Vec3,
} from '../../../helpers.js';
import {
  firstTouch,
  fromBall,
  fromBox,
  fromFrustum,
  plus,
  size,
  type Distance,
} from './distances.js';

/** Steps of 1/60 s, in which nothing falls. */
const STILL = { ...WEIGHTLESS, accuracy: 'game' };

const DT = 1 / 60;

const out = new Float64Array(METS);
const speed = new Float64Array(3);

/** What is met between two points in the step that was taken last. */
function met(obstacles: Obstacles, from: Vec3, to: Vec3, radius = 0, since = 0, until = 1) {
  const a = Float64Array.from(from);
  if (!obstacles.meet(a, Float64Array.from(to), radius, out, since, until)) return undefined;
  obstacles.velocityAt(out, speed);
  const three = (at: number) => [...out.subarray(at, at + 3)] as Vec3;
  return {
    share: out[MET.share]!,
    depth: out[MET.depth]!,
    normal: three(MET.normal),
    point: three(MET.point),
    place: three(MET.place),
    body: out[MET.body]!,
    velocity: [...speed] as Vec3,
  };
}

/** After a step of a world. */
function stepped(w: World, obstacles = new Obstacles(w)): Obstacles {
  w.step();
  obstacles.take(DT);
  return obstacles;
}

/** Asks every box. */
class All implements Search {
  #boxes = new Float64Array(0);
  #count = 0;

  fill(boxes: Float64Array<ArrayBuffer>, count: number): void {
    this.#boxes = boxes;
    this.#count = count;
  }

  near(_box: Float64Array, found: Int32Array): number {
    for (let i = 0; i < this.#count; i++) found[i] = i;
    assert.ok(this.#boxes.length >= BOX * this.#count);
    return this.#count;
  }

  any(): boolean {
    return this.#count > 0;
  }
}

const next = random(11);
const either = (most: number): number => (2 * next() - 1) * most;
const somewhere = (most: number): Vec3 => [either(most), either(most), either(most)];

/** A body at some pose, and how far from it a point of the world is. */
interface Standing {
  fields: Record<string, unknown>;
  distance: Distance;
}

/** A point of the world in the frame of a rotation and a place. */
function into(place: Vec3, [x, y, z, angle]: number[], at: Vec3): Vec3 {
  const length = Math.hypot(x!, y!, z!);
  const axis: Vec3 = [x! / length, y! / length, z! / length];
  const v = plus(at, place, -1);
  const along = axis[0] * v[0] + axis[1] * v[1] + axis[2] * v[2];
  const turn: Vec3 = [
    axis[1] * v[2] - axis[2] * v[1],
    axis[2] * v[0] - axis[0] * v[2],
    axis[0] * v[1] - axis[1] * v[0],
  ];
  const [c, s] = [Math.cos(-angle!), Math.sin(-angle!)];
  return plus(plus([v[0] * c, v[1] * c, v[2] * c], turn, s), axis, along * (1 - c));
}

function standing(kind: number, spread: number): Standing {
  const place = somewhere(spread);
  const orientation = [either(1), either(1), 0.3 + next(), 3 * next()];
  const a = 0.2 + next();
  const b = 0.2 + next();
  const c = 0.2 + next();
  const forms: [object, Distance][] = [
    [box(a, b, c), fromBox([a / 2, b / 2, c / 2])],
    [sphere(a / 2), fromBall(a / 2)],
    [{ type: 'Cylinder', radius: a / 2, height: b }, fromFrustum(a / 2, a / 2, b / 2)],
    [{ type: 'Cone', bottomRadius: a / 2, height: b }, fromFrustum(a / 2, 0, b / 2)],
  ];
  const [geometry, form] = forms[kind % forms.length]!;
  return {
    fields: { fixed: true, position: place, orientation, geometry: [geometry] },
    distance: (at) => form(into(place, orientation, at)),
  };
}

fact(
  'of all bodies, however they stand, the first on a way is met, where and along its normal',
  async () => {
    const w = await world(STILL);
    const all = Array.from({ length: 30 }, (_, i) => standing(i, 2.5));
    const bodies = all.map(({ fields }) => addBody(w, fields));
    const obstacles = stepped(w);
    let count = 0;
    for (const radius of [0, 0.1]) {
      for (let i = 0; i < 60; i++) {
        const [from, to] = [somewhere(3), somewhere(3)];
        const touches = all.map(({ distance }) => firstTouch(distance, from, to, radius));
        if (touches.some(({ least }) => Math.abs(least) < 1e-5)) continue;
        const share = Math.min(
          ...touches.map((touch) => (touch.share >= 0 ? touch.share : Infinity)),
        );
        const found = met(obstacles, from, to, radius);
        assert.equal(found !== undefined, share < Infinity);
        if (!found || share === 0) continue;
        count++;
        // Bullet keeps poses in single precision.
        close(found.share, share, 1e-5, `share from ${from.join(' ')}`);
        const first = touches.findIndex((touch) => touch.share === share);
        assert.equal(found.body, bodies[first]!.slot);
        const { distance } = all[first]!;
        close(distance(found.place), radius, 1e-6, 'place');
        close(distance(found.point), 0, 1e-6, 'point');
        close(size(found.normal), 1, 1e-12);
        close(distance(plus(found.place, found.normal, 1e-2)), radius + 1e-2, 1e-5, 'normal');
        close(found.velocity, [0, 0, 0], 0);
      }
    }
    assert.ok(count > 25, `${count} were met`);
  },
);

fact('ten thousand ways meet the same as when each asks every body', async () => {
  const w = await world({ ...STILL, gravity: [0, -9.8, 0] });
  addFloor(w);
  for (let i = 0; i < 40; i++) {
    const { fields } = standing(i, 4);
    const position = plus(fields.position as Vec3, [0, 5, 0]);
    const angularVelocity = somewhere(i % 4 === 0 ? 40 : 6);
    addBody(w, { ...fields, position, fixed: i % 5 === 0, angularVelocity });
  }
  // One that has left the others, and one that turns so far that it may be anywhere.
  addBody(w, { position: [0, -9000, 0] });
  addBody(w, { position: [0, 5, 6], geometry: [box(1, 0.1, 0.1)], angularVelocity: [0, 0, 150] });
  claim(w, 'initial-overlap');
  const [near, all] = [new Obstacles(w), new Obstacles(w, new All())];
  let count = 0;
  for (let step = 0; step < 5; step++) {
    w.step();
    near.take(DT);
    all.take(DT);
    for (let i = 0; i < 2000; i++) {
      const from = plus(somewhere(5), [0, 5, 0]);
      const to = plus(from, somewhere(i % 10 === 0 ? 5 : 0.2));
      const radius = i % 2 ? 0.05 : 0;
      const since = i % 3 ? 0 : 0.4;
      const a = met(near, from, to, radius, since);
      assert.deepEqual(a, met(all, from, to, radius, since));
      if (a) count++;
    }
  }
  assert.ok(count > 300, `${count} were met`);
});

fact(
  'what goes 100 m/s does not come through a plate of 1 mm, however that moves or turns',
  async () => {
    const motions: [Vec3, Vec3][] = [
      [
        [0, 0, 0],
        [0, 0, 0],
      ],
      [
        [0, 20, 0],
        [0, 0, 0],
      ],
      [
        [3, -10, 2],
        [4, 9, -7],
      ],
      [
        [0, 0, 0],
        [60, 0, 30],
      ],
    ];
    for (const [linearVelocity, angularVelocity] of motions) {
      const w = await world(STILL);
      addBody(w, {
        orientation: [1, 0.3, -0.4, 0.7],
        geometry: [box(40, 0.001, 40)],
        linearVelocity,
        angularVelocity,
      });
      const obstacles = new Obstacles(w);
      let particles = Array.from({ length: 60 }, (_, i) => {
        const at = plus(somewhere(1), [0, 12, 0]);
        const way = plus(somewhere(3), at, -1);
        return { at, way: plus([0, 0, 0], way, (100 * DT) / size(way)), radius: i % 2 ? 0.002 : 0 };
      });
      for (let step = 0; step < 24; step++) {
        stepped(w, obstacles);
        particles = particles.filter((each) => {
          const from = each.at;
          each.at = plus(from, each.way);
          return !met(obstacles, from, each.at, each.radius);
        });
      }
      assert.equal(particles.length, 0);
    }
  },
);

fact('a ball that moves is met where both are at the time', async () => {
  const w = await world(STILL);
  const ball = addBody(w, { position: [0, 0, 0], linearVelocity: [12, 0, 0] });
  const obstacles = stepped(w);
  // It comes from 0 to 0.2, and the particle from 1 to 0.6 at the height of 0.3: its surface is 0.4 before its middle.
  const found = met(obstacles, [1, 0.3, 0], [0.6, 0.3, 0])!;
  close(found.share, 1, 1e-6);
  const half = met(obstacles, [0.8, 0.3, 0], [0.4, 0.3, 0])!;
  close(half.share, 2 / 3, 1e-6);
  close(half.place, [0.8 - 0.8 / 3, 0.3, 0], 1e-6);
  close(half.normal, [0.8, 0.6, 0], 1e-6);
  close(half.velocity, [12, 0, 0], 1e-4);
  assert.equal(half.body, ball.slot);
  // From half of the step on it has less time, and the ball is nearer.
  const later = met(obstacles, [0.7, 0.3, 0], [0.5, 0.3, 0], 0, 0.5)!;
  close(later.share, 2 / 3, 1e-6);
});

fact(
  'what stands still is met by what comes over it, with the velocity of the point that meets it',
  async () => {
    const w = await world(STILL);
    // A blade of 2 m about z, 3 rad/s.
    addBody(w, {
      position: [0, 0, 0],
      orientation: [0, 0, 1, -0.025],
      geometry: [box(2, 0.02, 0.5)],
      angularVelocity: [0, 0, 3],
      angularDampingFactor: 0,
    });
    const obstacles = stepped(w);
    // It turns from -0.025 to 0.025, its face 1 cm before its middle: at x = 0.8 that passes y = 0 at an angle of -0.0125.
    const found = met(obstacles, [0.8, 0, 0], [0.8, 0, 0])!;
    close(found.share, (0.025 - Math.asin(0.01 / 0.8)) / 0.05, 0.01);
    close(found.normal, [Math.sin(0.0125), Math.cos(0.0125), 0], 1e-3);
    close(found.velocity, [0, 2.4, 0], 0.01);
    close(found.place, [0.8, 0, 0], 0.001);
  },
);

fact(
  'on what turns fast the place is right within 2 mm, and a rest of a way goes on from there',
  async () => {
    const w = await world(STILL);
    // A wheel of 1 m, 18 rad/s, seen by what falls past it.
    addBody(w, {
      geometry: [box(1.6, 0.1, 0.5)],
      angularVelocity: [0, 0, 18],
      angularDampingFactor: 0,
    });
    const obstacles = stepped(w);
    const [from, to]: Vec3[] = [
      [0.6, 1, 0.1],
      [0.7, -0.5, 0.1],
    ];
    const form = fromBox([0.8, 0.05, 0.25]);
    let share = 0;
    const at = (s: number): Vec3 => plus(from!, plus(to!, from!, -1), s);
    // Where it is by its own turn: finely sampled.
    while (share < 1 && form(into([0, 0, 0], [0, 0, 1, share * 18 * DT], at(share))) > 0)
      share += 1e-5;
    const found = met(obstacles, from!, to!)!;
    close(found.share, share, 0.002 / 1.5);
    close(found.place, at(share), 0.004);
    const rest = met(obstacles, found.place, plus(found.place, [0.01, 0.5, 0]), 0, found.share);
    assert.equal(rest, undefined);
  },
);

fact(
  'on what turns and moves a way meets the surface, within 2 mm of where fine samples of both find it',
  async () => {
    const w = await world(STILL);
    const half: Vec3 = [0.8, 0.05, 0.4];
    const body = addBody(w, {
      geometry: [box(1.6, 0.1, 0.8)],
      linearVelocity: [1, 2, 0],
      angularVelocity: [2, -3, 9],
    });
    const form = fromBox(half);
    const obstacles = new Obstacles(w);
    let count = 0;
    for (let step = 0; step < 10; step++) {
      stepped(w, obstacles);
      const at = POSE * body.slot;
      const a = [...w.poses.previous.subarray(at, at + POSE)];
      const b = [...w.poses.current.subarray(at, at + POSE)];
      const same = a.slice(3).reduce((sum, value, k) => sum + value * b[3 + k]!, 0);
      const distance = (point: Vec3, share: number): number => {
        const pose = a.map(
          (value, k) => value + ((k > 2 && same < 0 ? -1 : 1) * b[k]! - value) * share,
        );
        return form(into(pose.slice(0, 3) as Vec3, rotationOf(pose.slice(3)), point));
      };
      for (let i = 0; i < 40; i++) {
        const from = plus(a.slice(0, 3) as Vec3, somewhere(1));
        const way = somewhere(0.6);
        const on = (share: number): Vec3 => plus(from, way, share);
        if (distance(from, 0) <= 0) continue;
        let share = 0;
        while (share <= 1 && distance(on(share), share) > 0) share += 2e-3;
        const found = met(obstacles, from, on(1));
        // One that only cuts a corner between two samples.
        if (!found !== share > 1 && found && distance(on(found.share), found.share) < 2e-3)
          continue;
        assert.equal(found === undefined, share > 1, `from ${from.join(' ')}`);
        if (!found) continue;
        count++;
        close(distance(found.place, found.share), 0, 1e-12, 'surface');
        close(found.place, on(found.share), 0.002, 'place');
      }
    }
    assert.ok(count > 15, `${count} were met`);
  },
);

fact('what a body is put over is out of it, and so is what is born in it', async () => {
  const w = await world(STILL);
  const body = addBody(w, { fixed: true, position: [5, 0, 0], geometry: [box(2, 1, 2)] });
  const obstacles = stepped(w);
  assert.equal(met(obstacles, [0, 0.3, 0.1], [0, 0.3, 0.2]), undefined);
  body.set('position', [0, 0, 0]);
  stepped(w, obstacles);
  for (const radius of [0, 0.05]) {
    const found = met(obstacles, [0, 0.3, 0.1], [0, 0.3, 0.2], radius)!;
    close([found.share, found.depth], [0, 0.2 + radius], 1e-6);
    close(found.normal, [0, 1, 0], 1e-6);
    close(found.place, [0, 0.5 + radius, 0.1], 1e-6);
    close(found.point, [0, 0.5, 0.1], 1e-6);
    close(found.velocity, [0, 0, 0], 0);
  }
});

/** A cube of triangles, hollow. */
const cube = (half: number) => ({
  type: 'IndexedFaceSet',
  coord: [-1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1, -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1].map(
    (s) => s * half,
  ),
  coordIndex: [
    [0, 3, 2, 1, -1, 4, 5, 6, 7, -1, 0, 1, 5, 4, -1],
    [1, 2, 6, 5, -1, 2, 3, 7, 6, -1, 3, 0, 4, 7, -1],
  ].flat(),
});

fact(
  'what bounces about in a box of triangles stays in it while that is turned and shaken',
  async () => {
    for (const restitution of [0.9, 0]) {
      const w = await world(STILL);
      addBody(w, { position: [30, 0, 0] });
      const room = addBody(w, { fixed: true, geometry: [cube(1)] });
      const obstacles = stepped(w);
      const particles = Array.from({ length: 60 }, (_, i) => ({
        at: Float64Array.from(somewhere(0.9)),
        velocity: Float64Array.from(somewhere(i % 10 === 0 ? 60 : 5)),
        radius: i % 2 ? 0.02 : 0,
      }));
      const to = new Float64Array(3);
      for (let step = 0; step < 120; step++) {
        const turn = [1, 1, 0.3, 0.06 * (step + 1)];
        const place: Vec3 = [0.3 * Math.sin(0.2 * (step + 1)) - 0.06, 0.02 * step, 0];
        room.set('position', place);
        room.set('orientation', turn);
        stepped(w, obstacles);
        for (const { at, velocity, radius } of particles) {
          velocity[1]! -= 9.8 * DT;
          let since = 0;
          for (let bounce = 0; since < 1; bounce++) {
            for (let k = 0; k < 3; k++) to[k] = at[k]! + velocity[k]! * DT * (1 - since);
            if (!obstacles.meet(at, to, radius, out, since)) {
              at.set(to);
              break;
            }
            since = out[MET.time]!;
            at.set(out.subarray(MET.place, MET.place + 3));
            obstacles.velocityAt(out, speed);
            let along = 0;
            for (let k = 0; k < 3; k++) along += (velocity[k]! - speed[k]!) * out[MET.normal + k]!;
            for (let k = 0; k < 3; k++)
              velocity[k]! -= (1 + restitution) * Math.min(0, along) * out[MET.normal + k]!;
            if (bounce < 8) continue;
            obstacles.ride(out, at);
            break;
          }
          const local = into(place, turn, [...at] as Vec3);
          const out2 = Math.max(...local.map(Math.abs));
          assert.ok(out2 <= 1 + 1e-9 - radius * 0.99, `${local.join(' ')} in step ${step}`);
        }
      }
    }
  },
);

fact('what is carried is met on its way, with its velocity', async () => {
  const w = await world(STILL);
  addBody(w, { position: [30, 0, 0] });
  const lift = addBody(w, { fixed: true, geometry: [box(2, 0.1, 2)] });
  const obstacles = stepped(w);
  let found: ReturnType<typeof met>;
  let steps = 0;
  for (; steps < 20 && !found; steps++) {
    lift.set('position', [0, 0.02 * (steps + 1), 0]);
    stepped(w, obstacles);
    found = met(obstacles, [0.3, 0.1, 0.2], [0.3, 0.1, 0.2]);
  }
  close(found!.normal, [0, 1, 0], 1e-6);
  close(found!.point, [0.3, 0.1, 0.2], 1e-6);
  close(found!.velocity, [0, 0.02 / DT, 0], 1e-3);
});

fact('parts of a body, meshes, hulls and eggs are met by their own forms', async () => {
  const w = await world(STILL);
  const square = { coord: [-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1], coordIndex: [0, 3, 2, 1, -1] };
  const at = (x: number, geometry: object[], fields: object = {}) =>
    addBody(w, { fixed: true, position: [x, 0, 0], geometry, ...fields });
  at(0, [{ type: 'IndexedFaceSet', ...square }]);
  at(10, [{ type: 'Sphere', radius: 1, linear: [1, 0, 0, 0, 0.5, 0, 0, 0, 2] }]);
  at(20, [
    { ...box(1), translation: [0, 2, 0] },
    { ...sphere(0.5), translation: [0, -2, 0] },
  ]);
  const height = [0, 0, 0, 1, 1, 1];
  at(30, [{ type: 'ElevationGrid', xDimension: 3, zDimension: 2, height }]);
  const tetra = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1];
  const faces = [0, 2, 1, -1, 0, 1, 3, -1, 0, 3, 2, -1, 1, 2, 3, -1];
  at(40, [{ type: 'IndexedFaceSet', coord: tetra, coordIndex: faces }], { fixed: false });
  at(50, [{ type: 'Torus', innerRadius: 0.5, outerRadius: 2 }]);
  const obstacles = stepped(w);
  const down = (x: number, z = 0) => met(obstacles, [x, 8, z], [x, -8, z])!;
  const up = (x: number, z = 0) => met(obstacles, [x, -8, z], [x, 8, z])!;
  close([...down(0.2).point, ...down(0.2).normal], [0.2, 0, 0, 0, 1, 0], 2e-6);
  close([...up(0.2).point, ...up(0.2).normal], [0.2, 0, 0, 0, -1, 0], 2e-6);
  close([...down(10).point, ...down(10).normal], [10, 0.5, 0, 0, 1, 0], 1e-6);
  close(down(10.6).point, [10.6, 0.4, 0], 1e-6);
  close(down(10, 1.2).point, [10, 0.4, 1.2], 1e-6);
  close(down(20).point, [20, 2.5, 0], 1e-6);
  close(up(20).point, [20, -2.5, 0], 1e-6);
  const slope = down(31.2, 0.5);
  close(slope.point, [31.2, 0.5, 0.5], 3e-6);
  close(slope.normal, [0, Math.SQRT1_2, -Math.SQRT1_2], 1e-6);
  const r = Math.sqrt(1 / 3);
  close(down(40.2, 0.2).normal, [r, r, r], 1e-6);
  close(down(40.2, 0.2).point, [40.2, 0.6, 0.2], 1e-5);
  close(down(50).point, [50, 2.5, 0], 2e-6);
  assert.equal(met(obstacles, [50, 0, 8], [50, 0, -8]), undefined);
});

fact('bodies that come, go and change are met as they are', async () => {
  const w = await world(STILL);
  const obstacles = stepped(w);
  const look = () => met(obstacles, [0, 3, 0], [0, -3, 0])?.share;
  assert.equal(look(), undefined);
  const body = addBody(w, { fixed: true, geometry: [box(1)] });
  stepped(w, obstacles);
  close(look()!, 2.5 / 6, 1e-6);
  body.set('geometry', [sphere(1)]);
  stepped(w, obstacles);
  close(look()!, 2 / 6, 1e-6);
  body.set('enabled', false);
  stepped(w, obstacles);
  assert.equal(look(), undefined);
  body.set('enabled', true);
  stepped(w, obstacles);
  close(look()!, 2 / 6, 1e-6);
  body.remove();
  stepped(w, obstacles);
  assert.equal(look(), undefined);
});

fact('far from the origin ways are as the author has them', async () => {
  const w = await world(STILL);
  addBody(w, { fixed: true, position: [10000, 50, -20000], geometry: [box(1)] });
  const obstacles = stepped(w);
  const found = met(obstacles, [10000.2, 52, -20000], [10000.2, 49, -20000])!;
  close(found.point, [10000.2, 50.5, -20000], 1e-6);
});
