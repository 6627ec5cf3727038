import { cos, sin } from '../../../physics-core/base/exact/index.js';
import type { World } from '../../../physics-core/inside.js';
import type { StabilityCase } from '../case.js';
import {
  addBody,
  addFloor,
  addHinge,
  addJoint,
  box,
  distance,
  fastest,
  greatest,
  height,
  most,
  nothingCollides,
  position,
  sphere,
  spin,
  widest,
  type Body,
  type Joint,
} from '../scene.js';

// Joints that stop, close loops, mesh and roll.

/** A gear about z as a mesh: teeth between two radii, so deep. */
function gear(teeth: number, inner: number, outer: number, deep: number, phase: number) {
  const count = 4 * teeth;
  const outline = Array.from({ length: count }, (_, i) => {
    const angle = ((i + phase * 4 - 0.5) * Math.PI * 2) / count;
    const radius = i % 4 < 2 ? outer : inner;
    // Teeth taper towards their tips.
    const bend = i % 4 === 0 ? 0.35 : i % 4 === 1 ? -0.35 : i % 4 === 2 ? 0.1 : -0.1;
    const at = angle + (bend * Math.PI * 2) / count;
    return [radius * cos(at), radius * sin(at)];
  });
  const coord = [-deep / 2, deep / 2].flatMap((z) => [
    ...[0, 0, z],
    ...outline.flatMap(([x, y]) => [x!, y!, z]),
  ]);
  const other = count + 1;
  const index = outline.flatMap((_, i) => {
    const [a, b] = [1 + i, 1 + ((i + 1) % count)];
    return [
      ...[0, b, a],
      ...[other, other + a, other + b],
      ...[a, b, other + b],
      ...[a, other + b, other + a],
    ];
  });
  return { type: 'IndexedTriangleSet', coord, index };
}

/** Hills of a few centimetres over cells of half a metre, from −10 to 10 m. */
const hills = {
  type: 'ElevationGrid',
  xDimension: 41,
  zDimension: 41,
  xSpacing: 0.5,
  zSpacing: 0.5,
  height: Array.from({ length: 41 * 41 }, (_, i) => 0.04 * sin(i % 41) * cos(Math.floor(i / 41))),
  translation: [-10, 0, -10],
};

interface Cart {
  chassis: Body;
  wheels: Body[];
  joints: Joint[];
}

/** A chassis on four wheels of 0.3 m that turn about z, at 0.3 m above `y`. */
function cart(w: World, x: number, y: number, speed: number): Cart {
  const linearVelocity = [speed, 0, 0];
  const chassis = addBody(w, {
    mass: 5,
    position: [x, y + 0.5, 0],
    linearVelocity,
    geometry: [box(1.6, 0.2, 0.7)],
  });
  const all = [-0.6, 0.6].flatMap((dx) =>
    [-0.5, 0.5].map((z) => {
      const wheel = addBody(w, {
        position: [x + dx, y + 0.3, z],
        orientation: [1, 0, 0, Math.PI / 2],
        linearVelocity,
        angularVelocity: [0, 0, -speed / 0.3],
        geometry: [{ type: 'Cylinder', radius: 0.3, height: 0.15 }],
      });
      const joint = addHinge(w, {
        body1: wheel,
        body2: chassis,
        axis: [0, 0, 1],
        anchorPoint: [x + dx, y + 0.3, z],
      });
      return { wheel, joint };
    }),
  );
  return { chassis, wheels: all.map(({ wheel }) => wheel), joints: all.map(({ joint }) => joint) };
}

export const mechanisms: StabilityCase[] = [
  {
    id: 'S20',
    says: 'a motor holds a hinge at its stop',
    seconds: 3,
    criterion: { what: 'beyond the stop', unit: 'rad', most: 0.01 },
    promisedFrom: 'game',
    work: 'a motor',
    world: { gravity: [0, 0, 0] },
    scene(w) {
      const ball = addBody(w);
      const hinge = addHinge(w, { body1: ball, axis: [0, 1, 0], maxAngle: 0.5 });
      w.add('MotorJoint', { body1: ball, motor1Axis: [0, 1, 0], axis1Torque: 1 });
      return greatest(() => (w.time > 2 ? Math.abs(hinge.angle - 0.5) : hinge.angle - 0.5));
    },
  },
  {
    id: 'S21',
    says: 'a loop with two joints too many neither drifts nor buzzes',
    load: { of: 'joints', ratio: 6 },
    seconds: 5,
    criterion: { what: 'off its place; speed, m/s, after 3 s', unit: 'm', most: 0.02 },
    promisedFrom: 'game',
    lowest: -2,
    scene(w) {
      const at = [
        [1, 0, 0],
        [1, -1, 0],
        [-1, -1, 0],
        [-1, 0, 0],
      ];
      const corners = at.map((place) => addBody(w, { position: place, geometry: [sphere(0.2)] }));
      corners.forEach((corner, i) =>
        addHinge(w, {
          body1: corner,
          body2: corners[(i + 1) % 4],
          axis: [0, 0, 1],
          anchorPoint: at[i],
        }),
      );
      addJoint(w, 'BallJoint', { body1: corners[0], anchorPoint: at[0] });
      addJoint(w, 'BallJoint', { body1: corners[3], anchorPoint: at[3] });
      return greatest(() => {
        const off = most(corners.map((corner, i) => distance(position(corner), at[i]!)));
        return w.time > 3 ? Math.max(off, fastest(corners)) : off;
      });
    },
  },
  {
    id: 'S19',
    says: 'a gear of a concave mesh drives another, tooth by tooth',
    seconds: 5,
    finest: 'fine',
    criterion: { what: 'teeth out of mesh', unit: 'teeth', most: 0.5 },
    promisedFrom: 'game',
    work: 'a motor',
    world: { gravity: [0, 0, 0] },
    scene(w) {
      const [first, second] = [0, 0.5].map((phase) =>
        w.add('CollidableShape', { shape: [gear(12, 0.85, 1.1, 0.3, phase)] }),
      );
      const space = w.add('CollisionSpace', {
        collidables: [first, second],
        useGeometry: true,
      });
      w.add('CollisionCollection', { collidables: [space] });
      const gears = [first, second].map((shape, i) =>
        addBody(w, { position: [2.02 * i, 0, 0], geometry: [shape] }),
      );
      gears.forEach((body, i) =>
        addHinge(w, { body1: body, axis: [0, 0, 1], anchorPoint: [2.02 * i, 0, 0] }),
      );
      w.add('MotorJoint', { body1: gears[0], motor1Axis: [0, 0, 1], axis1Torque: 0.2 });
      let turned = [0, 0];
      return greatest(() => {
        turned = turned.map((angle, i) => angle + spin(gears[i]!)[2] * w.timeStep);
        return Math.abs(turned[0]! + turned[1]!) / ((Math.PI * 2) / 12);
      });
    },
  },
  {
    id: 'S19 hull',
    says: 'a concave body falls on a concave body and does not fall through',
    seconds: 4,
    criterion: { what: 'below the one it lies on', unit: 'm', most: 0 },
    promisedFrom: 'game',
    mayTell: ['concave-dynamic'],
    scene(w) {
      addFloor(w);
      const bowl = gear(8, 0.5, 1, 0.3, 0);
      const lower = addBody(w, {
        position: [0, 0.151, 0],
        orientation: [1, 0, 0, Math.PI / 2],
        geometry: [bowl],
      });
      const upper = addBody(w, {
        position: [0.1, 1, 0],
        orientation: [1, 0, 0, Math.PI / 2],
        geometry: [bowl],
      });
      return greatest(() => 0.29 - (height(upper) - height(lower)));
    },
  },
  {
    id: 'seams',
    says: 'a cart rolls over the seams of a flat height field as over a plane',
    seconds: 5,
    criterion: { what: 'speed lost or gained, of its speed', unit: '', most: 0.01 },
    promisedFrom: 'game',
    scene(w) {
      addBody(w, { fixed: true, geometry: [{ ...hills, height: Array(41 * 41).fill(0) }] });
      const { chassis } = cart(w, -8, 0, 3);
      return greatest(() => Math.abs((chassis.get('linearVelocity') as number[])[0]! / 3 - 1));
    },
  },
  {
    id: 'hills',
    says: 'a cart rolls over the hills of a height field and keeps its wheels',
    seconds: 4,
    criterion: { what: 'widest gap', unit: 'm', most: 1e-3 },
    promisedFrom: 'game',
    scene(w) {
      addBody(w, { fixed: true, geometry: [hills] });
      const { chassis, joints, wheels } = cart(w, -8, 0.1, 4);
      return greatest(() =>
        most(wheels.map((wheel) => -height(wheel))) > 0 || Math.abs(position(chassis)[2]) > 9
          ? NaN
          : widest(joints),
      );
    },
  },
  {
    id: 'ladder',
    says: 'a ladder leans on a wall and does not slip',
    seconds: 20,
    criterion: { what: 'farthest from its place', unit: 'm', most: 1e-3 },
    promisedFrom: 'game',
    scene(w) {
      addFloor(w);
      addBody(w, { fixed: true, position: [-0.5, 5, 0], geometry: [box(1, 10, 10)] });
      // tan of the lean may be up to 2 μ / (1 − μ²) = 1.33 where both rub by 0.5.
      const [lean, long, thick] = [0.7, 4, 0.1];
      const x = (long / 2) * sin(lean) + (thick / 2) * cos(lean);
      const y = (long / 2) * cos(lean) + (thick / 2) * sin(lean);
      const ladder = addBody(w, {
        mass: 8,
        position: [x, y, 0],
        orientation: [0, 0, 1, lean],
        geometry: [box(thick, long, 0.5)],
      });
      const before = position(ladder);
      return greatest(() => distance(position(ladder), before));
    },
  },
  {
    id: 'ring',
    says: 'a chain tied to itself, thrown, gains no energy and does not gape',
    load: { of: 'links', ratio: 20 },
    seconds: 10,
    criterion: { what: 'widest gap', unit: 'm', most: 1e-3 },
    promisedFrom: 'game',
    lowest: -600,
    scene(w) {
      nothingCollides(w);
      const radius = 1;
      const rods = Array.from({ length: 20 }, (_, i) => {
        const angle = (Math.PI * 2 * (i + 0.5)) / 20;
        return addBody(w, {
          position: [radius * cos(angle), radius * sin(angle), 0],
          orientation: [0, 0, 1, angle + Math.PI / 2],
          linearVelocity: [0, 0, i % 4],
          geometry: [box(0.28, 0.05, 0.05)],
        });
      });
      const out = radius / cos(Math.PI / 20);
      const joints = rods.map((rod, i) => {
        const angle = (Math.PI * 2 * (i + 1)) / 20;
        return addJoint(w, 'BallJoint', {
          body1: rod,
          body2: rods[(i + 1) % 20],
          anchorPoint: [out * cos(angle), out * sin(angle), 0],
        });
      });
      return greatest(() => widest(joints));
    },
  },
];
