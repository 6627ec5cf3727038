import type { World } from '../../../../../physics-core/inside.js';
import { multiply, quaternionOf, rotationOf } from '../../../../../physics-core/base/math.js';
import {
  addBody,
  addFloor,
  addJoint,
  below,
  box,
  fact,
  position,
  velocity,
  world,
  type Body,
} from '../../../../core/helpers.js';

// What lies on a line rolls on it: its contact points are those of where it is now, and none pushes from behind.

const G = 9.81;
const HEADINGS = [0, 17, 45, 90];
const LEVELS = [
  ['standard', 0.02],
  ['game', 0.05],
] as const;

type Numbers = [number, number, number];
const speed = (body: Body): number => Math.hypot(...velocity(body));
const radians = (degrees: number): number => (degrees * Math.PI) / 180;
const times = (v: Numbers, s: number): Numbers => [v[0] * s, v[1] * s, v[2] * s];

/** A cylinder that rolls at right angles to its axis, which is turned so far about the vertical. */
function rolling(w: World, radius: number, height: number, heading: number, pace: number): Body {
  const a = radians(heading);
  const turned = multiply(quaternionOf([0, 1, 0, -a]), quaternionOf([0, 0, 1, -Math.PI / 2]));
  return addBody(w, {
    position: [0, radius, 0],
    orientation: rotationOf(turned),
    linearVelocity: times([-Math.sin(a), 0, Math.cos(a)], pace),
    angularVelocity: times([Math.cos(a), 0, Math.sin(a)], pace / radius),
    geometry: [{ type: 'Cylinder', radius, height }],
  });
}

for (const [accuracy, share] of LEVELS)
  fact(`a cylinder and a wheel that roll for 30 s keep their speed at ${accuracy}`, async () => {
    for (const heading of HEADINGS)
      for (const [radius, height, pace] of [
        [0.3, 1, 0.2],
        [0.3, 0.1, 1],
      ] as const) {
        const w = await world({ gravity: [0, -G, 0], accuracy });
        addFloor(w, 0, { geometry: [box(100, 1, 100)] });
        const body = rolling(w, radius, height, heading, pace);
        w.advance(30);
        const what = `${height} m long, turned by ${heading}°`;
        below(Math.abs(speed(body) / pace - 1), share, `speed, ${what}`);
        below(Math.abs(position(body)[1] - radius), 2e-4, `height, ${what}`);
      }
  });

/** A cone that rolls about its tip, which lies in the middle of the floor, once around in 2π / `turn` seconds. */
function circling(w: World, radius: number, length: number, heading: number, turn: number): Body {
  const half = Math.atan2(radius, length);
  const a = radians(heading);
  const tilt = multiply(quaternionOf([0, 1, 0, -a]), quaternionOf([0, 0, 1, Math.PI / 2 + half]));
  const middle: Numbers = [
    (Math.cos(a) * Math.cos(half) * length) / 2,
    (Math.sin(half) * length) / 2,
    (Math.sin(a) * Math.cos(half) * length) / 2,
  ];
  // It turns about the line that it lies on, so that its axis goes around.
  const spin = turn / Math.tan(half);
  const along: Numbers = [Math.cos(a) * spin, 0, Math.sin(a) * spin];
  const body = addBody(w, {
    position: middle,
    orientation: rotationOf(tilt),
    angularVelocity: along,
    linearVelocity: [
      -along[2] * middle[1],
      along[2] * middle[0] - along[0] * middle[2],
      along[0] * middle[1],
    ],
    geometry: [{ type: 'Cone', bottomRadius: radius, height: length }],
  });
  return body;
}

for (const [accuracy, share] of LEVELS)
  fact(`a cone that rolls about its tip for 30 s keeps its pace at ${accuracy}`, async () => {
    for (const heading of HEADINGS) {
      const w = await world({ gravity: [0, -G, 0], accuracy });
      addFloor(w);
      const body = circling(w, 0.3, 1, heading, 0.3);
      const start = speed(body);
      w.advance(30);
      below(Math.abs(speed(body) / start - 1), share, `speed, turned by ${heading}°`);
    }
  });

fact('a cart on four hinged wheels that nothing drives does not roll away', async () => {
  const w = await world({ gravity: [0, -G, 0] });
  addFloor(w);
  const cart = addBody(w, {
    mass: 10,
    position: [0, 0.5, 0],
    geometry: [{ type: 'Box', size: [2, 0.3, 1] }],
  });
  for (const x of [-0.8, 0.8])
    for (const z of [-0.6, 0.6]) {
      const wheel = addBody(w, {
        position: [x, 0.3, z],
        orientation: [1, 0, 0, Math.PI / 2],
        geometry: [{ type: 'Cylinder', radius: 0.3, height: 0.1 }],
      });
      addJoint(w, 'SingleAxisHingeJoint', {
        body1: cart,
        body2: wheel,
        anchorPoint: [x, 0.3, z],
        axis: [0, 0, 1],
      });
    }
  w.advance(20);
  below(Math.abs(position(cart)[0]), 1e-3, 'way');
});

fact('two wheels on an axle that are one body roll on', async () => {
  const w = await world({ gravity: [0, -G, 0] });
  addFloor(w);
  const collidable = (geometry: object) => w.add('CollidableShape', { shape: [geometry] });
  const wheel = (x: number) => ({
    type: 'CollidableOffset',
    translation: [x, 0, 0],
    rotation: [0, 0, 1, Math.PI / 2],
    collidable: collidable({ type: 'Cylinder', radius: 0.3, height: 0.1 }),
  });
  const body = addBody(w, {
    position: [0, 0.3, -5],
    linearVelocity: [0, 0, 0.5],
    angularVelocity: [0.5 / 0.3, 0, 0],
    geometry: [wheel(-0.5), collidable(box(1, 0.1, 0.1)), wheel(0.5)],
  });
  w.advance(15);
  below(Math.abs(speed(body) / 0.5 - 1), 0.02, 'speed');
  below(Math.abs(position(body)[0]), 0.02, 'way to the side');
});
