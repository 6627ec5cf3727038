import assert from 'node:assert/strict';
import { describe } from 'node:test';
import { debugLines, type DebugLines } from '../../../../physics-core/debug-lines.js';
import type { World } from '../../../../physics-core/inside.js';
import { COLOR, type Color } from '../../../../physics-core/effects/debug/colors.js';
import {
  above,
  addBody,
  addFloor,
  addJoint,
  box,
  close,
  distance,
  fact,
  position,
  sphere,
  world,
  type Vec3,
} from '../../helpers.js';

type Line = [Vec3, Vec3];

const three = (numbers: Float32Array, at: number): Vec3 => [
  numbers[at]!,
  numbers[at + 1]!,
  numbers[at + 2]!,
];

/** The lines of one colour, drawn now. */
function linesOf(drawn: DebugLines, color: Color): Line[] {
  drawn.update();
  const found: Line[] = [];
  for (let i = 0; i < drawn.count; i++) {
    const own = three(drawn.colors, 6 * i);
    if (distance(own, color) > 1e-6) continue;
    found.push([three(drawn.positions, 6 * i), three(drawn.positions, 6 * i + 3)]);
  }
  return found;
}

const ends = (lines: Line[]): Vec3[] => lines.flat();

/** Each point once, within 1e-5 m. */
function distinct(points: Vec3[]): Vec3[] {
  const found: Vec3[] = [];
  for (const point of points)
    if (!found.some((other) => distance(point, other) < 1e-5)) found.push(point);
  return found;
}

const has = (points: Vec3[], wanted: Vec3, tolerance = 1e-6): boolean =>
  points.some((point) => distance(point, wanted) <= tolerance);

/** A body that hangs still. */
const still = (w: World, fields: Record<string, unknown>) =>
  addBody(w, { useGlobalGravity: false, ...fields });

describe('the debug drawing', () => {
  fact('has the 12 edges of a box at its pose, corners within 1e-6 m', async () => {
    const w = await world();
    still(w, {
      position: [1, 2, 3],
      orientation: [0, 0, 1, Math.PI / 2],
      geometry: [box(2, 4, 6)],
    });
    const lines = linesOf(await debugLines(w), COLOR.awake);
    assert.equal(lines.length, 12);
    const corners = distinct(ends(lines));
    assert.equal(corners.length, 8);
    // Turned by a quarter about z, x and y change places.
    for (const x of [-2, 2])
      for (const y of [-1, 1])
        for (const z of [-3, 3]) assert.ok(has(corners, [1 + x, 2 + y, 3 + z]), `${x} ${y} ${z}`);
  });

  fact('follows the body from step to step', async () => {
    const w = await world();
    const ball = addBody(w, { linearVelocity: [3, 0, 0], geometry: [sphere(0.5)] });
    const drawn = await debugLines(w);
    w.step(60);
    const points = ends(linesOf(drawn, COLOR.awake));
    above(points.length, 50);
    for (const point of points) close(distance(point, position(ball)), 0.5, 1e-5);
  });

  fact('has a hull by its true edges, in a compound at its place', async () => {
    const w = await world();
    const point = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1];
    const coordIndex = [0, 2, 1, -1, 0, 1, 3, -1, 0, 3, 2, -1, 1, 2, 3, -1];
    const tetrahedron = { type: 'IndexedFaceSet', coordIndex, coord: { point } };
    const body = still(w, {
      mass: 1,
      geometry: [
        { ...tetrahedron, translation: [5, 0, 0] },
        { ...box(1), translation: [-5, 0, 0] },
      ],
    });
    const lines = linesOf(await debugLines(w), COLOR.awake);
    assert.equal(lines.length, 6 + 12);
    const corners = distinct(ends(lines));
    assert.equal(corners.length, 4 + 8);
    const origin = position(body);
    for (const corner of [
      [5, 0, 0],
      [6, 0, 0],
      [5, 1, 0],
      [5, 0, 1],
      [-5.5, -0.5, 0.5],
    ] as Vec3[])
      assert.ok(has(corners, corner.map((x, i) => x + origin[i]!) as Vec3), `${corner}`);
  });

  fact('has a mesh by its triangles, each edge once', async () => {
    const w = await world();
    const coord = { point: [0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1] };
    const square = { type: 'IndexedTriangleSet', index: [0, 2, 1, 0, 3, 2], coord };
    still(w, { fixed: true, geometry: [square] });
    const lines = linesOf(await debugLines(w), COLOR.fixed);
    assert.equal(lines.length, 5);
    for (const [x, z] of [
      [0, 0],
      [1, 0],
      [1, 1],
      [0, 1],
    ] as const)
      assert.ok(has(ends(lines), [x, 0, z]));
  });

  fact('marks the centre of mass, not the origin', async () => {
    const w = await world();
    still(w, { centerOfMass: [0, 1, 0], position: [4, 0, 0], geometry: [box(1)] });
    const crosses = linesOf(await debugLines(w), COLOR.mass);
    assert.equal(crosses.length, 3);
    for (const [a, b] of crosses)
      close(
        a.map((x, i) => (x + b[i]!) / 2),
        [4, 1, 0],
        1e-6,
      );
  });

  fact(
    'has the links of a rope, and the edges of a cloth and of a soft body, each once, where they are now',
    async () => {
      const w = await world();
      const rope = w.add('Rope', {
        points: [
          [5, 2, 0],
          [6, 2, 0],
        ],
        segments: 4,
        fixedIndex: [0],
      });
      const cloth = w.add('Cloth', { size: [2, 1], subdivision: [2, 1], fixedIndex: [0] });
      const jelly = w.add('SoftBody', { geometry: { type: 'Box', size: [1, 1, 1] } });
      const drawn = await debugLines(w);
      w.advance(0.5);
      const lines = linesOf(drawn, COLOR.awake);
      // Of a rope of four links; of two squares with a diagonal each; of a box, whose sides have one each.
      close(lines.length, 4 + 9 + 18, 0, 'lines');
      const places = [rope, cloth, jelly].flatMap((node) => node.get('positions') as Vec3[]);
      for (const end of ends(lines))
        above(1e-5, Math.min(...places.map((at) => distance(at, end))));
      rope.set('enabled', false);
      w.advance(1 / 60);
      close(linesOf(drawn, COLOR.out).length, 4, 0, 'lines of what is not enabled');
      for (const node of [rope, cloth, jelly]) node.remove();
      close(linesOf(drawn, COLOR.awake).length, 0, 0, 'lines');
    },
  );

  fact('tells awake, sleeping, fixed, carried and disabled bodies by colour', async () => {
    const w = await world();
    const body = still(w, { geometry: [box(1)] });
    const drawn = await debugLines(w);
    const colors = (): string[] =>
      Object.entries(COLOR)
        .filter(([name]) => ['awake', 'sleeping', 'fixed', 'kinematic', 'out'].includes(name))
        .filter(([, color]) => linesOf(drawn, color).length === 12)
        .map(([name]) => name);
    assert.deepEqual(colors(), ['awake']);
    body.sleep();
    assert.deepEqual(colors(), ['sleeping']);
    body.set('fixed', true);
    w.step(1);
    assert.deepEqual(colors(), ['fixed']);
    body.event('position', [0.01, 0, 0]);
    w.step(0);
    assert.deepEqual(colors(), ['kinematic']);
    body.set('enabled', false);
    w.step(0);
    assert.deepEqual(colors(), ['out']);
  });

  fact('leaves the motion as it is, bit for bit', async () => {
    const run = async (draw: boolean): Promise<string> => {
      const w = await world();
      addFloor(w);
      const bodies = [0, 1, 2].map((i) =>
        addBody(w, { position: [0.1 * i, 1 + 1.1 * i, 0], geometry: [box(1)] }),
      );
      const drawn = await debugLines(w);
      for (let i = 0; i < 120; i++) {
        w.step(1);
        if (draw) drawn.update();
      }
      drawn.dispose();
      return JSON.stringify(bodies.map(position));
    };
    assert.equal(await run(true), await run(false));
  });

  fact('goes on after a reset, a level change, and bodies that come and go', async () => {
    const w = await world();
    const ball = still(w, { geometry: [box(1)] });
    const drawn = await debugLines(w);
    const boxes = (): number => linesOf(drawn, COLOR.awake).length / 12;
    assert.equal(boxes(), 1);
    w.reset();
    w.accuracy = 'fine';
    assert.equal(boxes(), 1);
    still(w, { position: [5, 0, 0], geometry: [box(1)] });
    assert.equal(boxes(), 2);
    ball.set('geometry', [box(4)]);
    const far = Math.max(...ends(linesOf(drawn, COLOR.awake)).map(([x]) => -x));
    close(far, 2, 1e-6);
    ball.remove();
    assert.equal(boxes(), 1);
  });

  fact("has a resting box's contacts at its corners on the ground, normals upwards", async () => {
    const w = await world();
    addFloor(w);
    addBody(w, { position: [2, 0.5, 0], geometry: [box(1)] });
    const drawn = await debugLines(w);
    w.advance(1);
    const lines = linesOf(drawn, COLOR.contact);
    assert.equal(lines.length, 4 * 4);
    const normals = lines.filter(([a, b]) => Math.abs(b[1] - a[1]) > 0.3);
    assert.equal(normals.length, 4);
    for (const [a, b] of normals) {
      close([Math.abs(a[0] - 2), a[1], Math.abs(a[2])], [0.5, 0, 0.5], 0.005);
      close(Math.abs(b[1] - a[1]), distance(a, b), 1e-6);
    }
  });

  fact("has a hinge's stops at the authored angles from where it stands", async () => {
    for (const swap of [false, true]) {
      const w = await world();
      const arm = still(w, { position: [1, 0, 0], geometry: [box(2, 0.2, 0.2)] });
      const hinge = addJoint(w, 'SingleAxisHingeJoint', {
        ...(swap ? { body2: arm } : { body1: arm }),
        anchorPoint: [0, 0, 0],
        axis: [0, 0, 1],
        minAngle: -0.5,
        maxAngle: 1,
      });
      const drawn = await debugLines(w);
      arm.set('angularVelocity', [0, 0, swap ? -0.6 : 0.6]);
      arm.set('linearVelocity', [0, swap ? -0.6 : 0.6, 0]);
      w.advance(0.5);
      const angle = hinge.get('angle') as number;
      above(angle, 0.2);
      const marks = [
        ...linesOf(drawn, COLOR.limit).slice(0, 2),
        linesOf(drawn, COLOR.joint).at(-1)!,
      ];
      const angles = marks.map(([from, to]) => Math.atan2(to[1] - from[1], to[0] - from[0]));
      // Along the arm; seen from body2 angles count the other way round.
      const [x, y] = position(arm);
      close(angles, [...(swap ? [-1, 0.5] : [-0.5, 1]), Math.atan2(y, x)], 1e-4, 'radians');
      close(Math.abs(angles[2]!), angle, 1e-3, 'radians');
    }
  });

  fact("has a wheel's steering stops, hard or soft, about its first axis", async () => {
    for (const stop1ConstantForceMix of [0, 0.1]) {
      const w = await world();
      const car = still(w, { fixed: true });
      const wheel = still(w, { position: [0, -1, 0] });
      const joint = addJoint(w, 'DoubleAxisHingeJoint', {
        body1: car,
        body2: wheel,
        anchorPoint: [0, -1, 0],
        axis1: [0, 1, 0],
        axis2: [0, 0, 1],
        minAngle1: -0.3,
        maxAngle1: 0.6,
        stop1ConstantForceMix,
      });
      const drawn = await debugLines(w);
      wheel.set('angularVelocity', [0, 0.5, 0]);
      w.advance(0.25);
      const angle = joint.get('hinge1Angle') as number;
      above(Math.abs(angle), 0.1);
      const marks = [
        ...linesOf(drawn, COLOR.limit).slice(0, 2),
        linesOf(drawn, COLOR.joint).at(-1)!,
      ];
      const [low, high, now] = marks.map(([from, to]) => to.map((x, i) => x - from[i]!) as Vec3);
      const between = (a: Vec3, b: Vec3): number =>
        Math.acos(
          (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) / (Math.hypot(...a) * Math.hypot(...b)),
        );
      close(
        [between(low!, high!), between(low!, now!), between(now!, high!)],
        [0.9, angle + 0.3, 0.6 - angle],
        1e-3,
        'radians',
      );
    }
  });

  fact('has the way that the stops of a slider leave its body', async () => {
    const w = await world();
    const cart = still(w, { position: [1, 0, 0], geometry: [box(0.5)] });
    const range = { minSeparation: -0.5, maxSeparation: 1.5 };
    addJoint(w, 'SliderJoint', { body1: cart, axis: [1, 0, 0], ...range });
    const drawn = await debugLines(w);
    cart.set('linearVelocity', [0.5, 0, 0]);
    w.advance(0.5);
    const [from, to] = linesOf(drawn, COLOR.limit)[0]!;
    close([...from, ...to], [0.5, 0, 0, 2.5, 0, 0], 1e-5, 'm');
  });
});
