import assert from 'node:assert/strict';
import { levelNames } from '../../../../physics-core/dynamics/levels.js';
import { applyInertia } from '../../../../physics-core/dynamics/inertia.js';
import type { World } from '../../../../physics-core/inside.js';
import {
  above,
  addBody,
  addFloor,
  addJoint,
  below,
  box,
  close,
  fact,
  height,
  position,
  sphere,
  spin,
  velocity,
  WEIGHTLESS,
  world,
  type Body,
  type Node,
  type Vec3,
} from '../../helpers.js';
import { faces } from '../../shapes/meshes.js';

// A wind pushes bodies by P A u², u being its speed relative to them, where its system pushes.

/** Pascal of a wind of 1 m/s. */
const PRESSURE = 0.64615;

/** Along x, without gusts, by a system that has no particles. */
const blow = (w: World, speed: number, wind = {}, system = {}): Node =>
  w.add('ParticleSystem', {
    maxParticles: 0,
    pushes: true,
    physics: [{ type: 'WindPhysicsModel', direction: [1, 0, 0], speed, gustiness: 0, ...wind }],
    ...system,
  });

/** Of what begins at rest, m/s and metres after `t` seconds: du/dt = -k u², k being P A / m. */
const speedAfter = (t: number, wind: number, k: number): number => wind - wind / (1 + k * wind * t);
const wayAfter = (t: number, wind: number, k: number): number =>
  wind * t - Math.log(1 + k * wind * t) / k;

const sizeOf = (v: readonly number[]): number => Math.hypot(...v);

for (const accuracy of levelNames) {
  fact(`at ${accuracy} a ball goes with the wind as the closed form has it`, async () => {
    const w = await world({ ...WEIGHTLESS, accuracy });
    const ball = addBody(w, { mass: 2 });
    blow(w, 20);
    const t = w.advance(1);
    const k = (PRESSURE * Math.PI * 0.25) / 2;
    const speed = speedAfter(t, 20, k);
    close(velocity(ball), [speed, 0, 0], 1e-5 * speed, 'm/s');
    close(position(ball), [wayAfter(t, 20, k), 0, 0], 2e-5, 'm');
  });

  fact(`at ${accuracy} one that falls in it falls as without it`, async () => {
    const w = await world({ accuracy, gravity: [0, -9.8, 0] });
    const ball = addBody(w, { mass: 2 });
    blow(w, 20, { direction: [0, -1, 0] });
    const t = w.advance(0.5);
    // What weight and wind do to each other is the square of a step, and no more.
    const k = (PRESSURE * Math.PI * 0.25) / 2;
    let [v, y] = [0, 0];
    for (let i = 0, dt = 1e-5; i < t / dt; i++) {
      const u = -20 - v;
      const a = -9.8 + k * Math.abs(u) * u;
      v += a * dt;
      y += v * dt;
    }
    close(velocity(ball)[1], v, 0.03, 'm/s');
    close(height(ball), y, 0.01, 'm');
  });

  fact(`at ${accuracy} no sheet is thrown beyond the wind`, async () => {
    const w = await world({ ...WEIGHTLESS, accuracy });
    const sheet = addBody(w, {
      mass: 0.001,
      orientation: [0, 0, 1, 0.4],
      geometry: [box(0.001, 2, 2)],
    });
    blow(w, 50);
    for (let i = 0; i < 60; i++) {
      w.step();
      below(sizeOf(velocity(sheet)), 50 + 1e-5, 'm/s');
    }
    above(velocity(sheet)[0], 49.9, 'm/s');
  });

  fact(`at ${accuracy} a plate that it turns gains no energy from it`, async () => {
    const w = await world({ ...WEIGHTLESS, accuracy });
    const plate = addBody(w, {
      mass: 0.5,
      orientation: [0, 0, 1, 0.3],
      centerOfMass: [0, 0.3, 0.2],
      geometry: [box(0.05, 2, 2)],
    });
    blow(w, 40);
    // Seen from what goes with the wind.
    const energy = (): number => {
      const turning = spin(plate);
      const momentum = applyInertia(plate, turning);
      const [vx, vy, vz] = w.bodies.velocityOf(plate);
      const linear = 0.25 * ((vx! - 40) ** 2 + vy! ** 2 + vz! ** 2);
      return linear + turning.reduce((sum, x, i) => sum + (x * momentum[i]!) / 2, 0);
    };
    const first = energy();
    close(first, 0.25 * 1600, 1e-9, 'J');
    let last = first;
    for (let i = 0; i < 400; i++) {
      w.step();
      const now = energy();
      below(now, last + 2e-3 * first, 'J');
      last = now;
    }
    below(last, first / 4, 'J');
  });
}

const along = (x: number, y: number, z: number): Vec3 => [x, y, z];

/** Forms, how the wind goes past them, what it sees, m², and where their middle is to be that none turns. */
const SIGHTS: [
  name: string,
  geometry: object,
  direction: Vec3,
  area: number,
  tolerance: number,
  fields?: object,
][] = [
  ['a box face on', box(1, 2, 3), along(1, 0, 0), 6, 1e-5],
  ['a box edge on', box(0.01, 2, 3), along(0, 0, 1), 0.02, 1e-5],
  ['a box corner on', box(1, 1, 1), along(1, 1, 1), Math.sqrt(3), 1e-5],
  ['a cylinder from the side', CYLINDER(), along(1, 0, 0), 2, 1e-5],
  ['a cylinder from above', CYLINDER(), along(0, -1, 0), Math.PI / 4, 1e-5],
  ['a cylinder from between', CYLINDER(), along(0, 1, 1), (2 + Math.PI / 4) * Math.SQRT1_2, 1e-5],
  ['a cone on its tip', CONE(), along(0, -1, 0), Math.PI / 4, 1e-5],
  ['a cone from the side', CONE(), along(0, 0, 1), 1, 1e-5, { centerOfMass: [0, -1 / 3, 0] }],
  ['a hull', faces(1, 2, 3), along(1, 0, 0), 6, 1e-5],
  ['a hull corner on', faces(1, 1, 1), along(-1, 1, 1), Math.sqrt(3), 1e-5],
  ['a sheet', { type: 'Rectangle2D', size: [2, 3] }, along(0, 0, -1), 6, 1e-5],
  [
    'a ball that is drawn out',
    { ...sphere(0.5), linear: [2, 0, 0, 0, 1, 0, 0, 0, 3] },
    along(1, 0, 0),
    (3 * Math.PI) / 4,
    1e-5,
  ],
];

function CYLINDER() {
  return { type: 'Cylinder', radius: 0.5, height: 2 };
}

function CONE() {
  return { type: 'Cone', bottomRadius: 0.5, height: 2 };
}

fact('a wind pushes on what it sees of a body', async () => {
  for (const [name, geometry, direction, area, tolerance, fields] of SIGHTS) {
    const w = await world(WEIGHTLESS);
    const body = addBody(w, { mass: 3, geometry: [geometry], ...fields });
    blow(w, 10, { direction });
    const t = w.advance(0.5);
    const speed = speedAfter(t, 10, (PRESSURE * area) / 3);
    const expected = direction.map((x) => (x / sizeOf(direction)) * speed);
    close(velocity(body), expected, tolerance * speed, name);
  }
});

fact('parts of a body add up', async () => {
  const w = await world(WEIGHTLESS);
  const parts = [box(1), { ...sphere(0.5), translation: [0, 3, 0] }];
  const centre = (3 * Math.PI) / 4 / (1 + Math.PI / 4);
  const body = addBody(w, { mass: 3, geometry: parts, centerOfMass: [0, centre, 0] });
  blow(w, 10);
  const t = w.advance(0.5);
  const speed = speedAfter(t, 10, (PRESSURE * (1 + Math.PI / 4)) / 3);
  close(velocity(body), [speed, 0, 0], 1e-5 * speed, 'm/s');
  close(spin(body), [0, 0, 0], 1e-6, 'rad/s');
});

fact('where a body is another its silhouette is, too', async () => {
  const w = await world(WEIGHTLESS);
  const body = addBody(w, { mass: 3e4, geometry: [box(1)] });
  blow(w, 10);
  w.advance(0.5);
  const before = velocity(body)[0];
  body.set('geometry', [box(2)]);
  const t = w.advance(0.5);
  const gained = velocity(body)[0] - before;
  close(gained, (PRESSURE * 4 * 100 * t) / 3e4, 2e-3 * gained, 'm/s');
});

fact(
  'a plate that is pushed off its centre of mass turns with the wind, by the moment',
  async () => {
    const w = await world(WEIGHTLESS);
    const plate = addBody(w, {
      mass: 50,
      geometry: [box(0.1, 2, 2)],
      centerOfMass: [0, 0.2, 0],
      inertia: [10, 0, 0, 0, 10, 0, 0, 0, 10],
    });
    blow(w, 5);
    const t = w.advance(0.1);
    const force = PRESSURE * 4 * 25;
    close(spin(plate), [0, 0, (0.2 * force * t) / 10], 0.02, 'rad/s');
    above(spin(plate)[2], 0.12, 'rad/s');
  },
);

for (const accuracy of ['game', 'standard', 'fine'])
  fact(`at ${accuracy} a vane on a hinge comes to point along the wind, and stays so`, async () => {
    const w = await world({ accuracy });
    const vane = addBody(w, {
      mass: 1,
      position: [0, 5, 0.5],
      geometry: [box(0.02, 0.5, 1)],
    });
    addJoint(w, 'SingleAxisHingeJoint', { body1: vane, axis: [0, 1, 0], anchorPoint: [0, 5, 0] });
    blow(w, 40);
    w.advance(5);
    for (let i = 0; i < 20; i++) {
      w.advance(0.25);
      close(position(vane), [0.5, 5, 0], 0.05, 'm');
      below(sizeOf(spin(vane)), 3, 'rad/s');
    }
  });

fact('what hangs in it hangs aslant by its weight and what the wind presses', async () => {
  const w = await world({ gravity: [0, -9.8, 0] });
  const angle = Math.atan2((PRESSURE * Math.PI * 0.25 * 100) / 5, 9.8);
  const at: Vec3 = [2 * Math.sin(angle), 8 - 2 * Math.cos(angle), 0];
  const bob = addBody(w, { mass: 5, position: at });
  addJoint(w, 'BallJoint', { body1: bob, anchorPoint: [0, 8, 0] });
  blow(w, 10);
  for (let i = 0; i < 8; i++) {
    w.advance(0.25);
    close(position(bob), at, 1e-3, 'm');
  }
});

/** On a floor with a friction of a half, in 64.6 N of wind. */
async function onFloor(mass: number, fields: Record<string, unknown> = {}) {
  const w = await world({ gravity: [0, -9.8, 0], ...fields });
  w.add('CollisionCollection', { collidables: '*', frictionCoefficients: [0.5, 0.5] });
  addFloor(w);
  const stone = addBody(w, { mass, position: [0, 0.5, 0], geometry: [box(1)] });
  return { w, stone };
}

fact('a heavy box on the floor stands in the wind, and a lighter one slides', async () => {
  const heavy = await onFloor(20);
  blow(heavy.w, 10);
  heavy.w.advance(3);
  close(position(heavy.stone)[0], 0, 1e-3, 'm');
  const light = await onFloor(10);
  blow(light.w, 10);
  const t = light.w.advance(0.5);
  // As long as it is slow, the wind loses 5 % of its push for each 0.25 m/s.
  const speed = velocity(light.stone)[0];
  const free = ((PRESSURE * 100 - 49) / 10) * t;
  assert.ok(speed < free && speed > 0.7 * free, `${speed} beside ${free}`);
});

fact('who does not ask for it has none, to the bit', async () => {
  const after = async (system?: object): Promise<number[]> => {
    const w = await world();
    addFloor(w);
    const bodies = [1, 2, 3].map((y) =>
      addBody(w, { position: [0.1 * y, 2 * y, 0], geometry: [box(1, 0.5, 0.7)] }),
    );
    if (system) blow(w, 30, {}, system);
    w.advance(2);
    return bodies.flatMap((body) => [...position(body), ...velocity(body), ...spin(body)]);
  };
  const calm = await after();
  assert.deepEqual(await after({ pushes: false }), calm);
  assert.deepEqual(await after({ enabled: false }), calm);
  assert.notDeepEqual(await after({}), calm);
});

fact('what is fixed, carried or weighs nothing is left where it is', async () => {
  const w = await world(WEIGHTLESS);
  const bodies = [
    addBody(w, { fixed: true, geometry: [box(2)] }),
    addBody(w, { enabled: false, position: [0, 5, 0] }),
    addBody(w, { position: [0, 10, 0], geometry: [] }),
  ];
  blow(w, 50);
  w.advance(1);
  bodies.forEach((body, i) => close(position(body), [0, 5 * i, 0], 0, 'm'));
});

fact('a gust is as strong for bodies as for particles', async () => {
  const w = await world(WEIGHTLESS);
  // So heavy that the speed of neither counts beside the wind's.
  const body = addBody(w, { mass: 1e5, geometry: [box(1)] });
  const system = blow(
    w,
    10,
    { gustiness: 0.8 },
    {
      maxParticles: 1,
      particleLifetime: 100,
      lifetimeVariation: 0,
      emitter: { type: 'PointEmitter', speed: 0, mass: 1e5, surfaceArea: 1, position: [0, 5, 0] },
    },
  );
  w.advance(1);
  const [[x]] = system.get('positions') as [Vec3];
  close(position(body)[0], x, 2e-4 * x, 'm');
});

fact('turbulence sends each body another way, the same one at each level', async () => {
  const at = async (accuracy: string): Promise<Vec3[]> => {
    const w = await world({ ...WEIGHTLESS, accuracy });
    const bodies = [0, 1, 2].map((i) => addBody(w, { mass: 20, position: [0, 5 * i, 0] }));
    blow(w, 10, { turbulence: 0.5, gustiness: 0.3 });
    w.advance(0.5);
    return bodies.map((body) => velocity(body));
  };
  const standard = await at('standard');
  const fine = await at('fine');
  standard.forEach((v, i) => close(v, fine[i]!, 1e-4, 'm/s'));
  for (const [i, j] of [
    [0, 1],
    [1, 2],
    [0, 2],
  ] as const)
    above(sizeOf(standard[i]!.map((x, k) => x - standard[j]![k]!)), 0.01, 'm/s');
});

fact('winds add up, of one system and of several, and never overshoot together', async () => {
  const k = (PRESSURE * Math.PI * 0.25) / 2;
  const wind = { type: 'WindPhysicsModel', direction: [1, 0, 0], speed: 10, gustiness: 0 };
  for (const systems of [[[wind, wind]], [[wind], [wind]]]) {
    const w = await world(WEIGHTLESS);
    const ball = addBody(w, { mass: 2 });
    const feather = addBody(w, { mass: 1e-4, position: [0, 9, 0] });
    for (const physics of systems) blow(w, 10, {}, { physics });
    const t = w.advance(1);
    const speed = speedAfter(t, 10, 2 * k);
    close(velocity(ball)[0], speed, 1e-5 * speed, 'm/s');
    below(velocity(feather)[0], 10 + 1e-5, 'm/s');
  }
});

fact('a wind that stands brakes what moves', async () => {
  const w = await world(WEIGHTLESS);
  const ball = addBody(w, { mass: 2, linearVelocity: [0, 0, 8] });
  blow(w, 0);
  const t = w.advance(1);
  const k = (PRESSURE * Math.PI * 0.25) / 2;
  close(velocity(ball), [0, 0, 8 / (1 + k * 8 * t)], 1e-4, 'm/s');
});

/** What tumbles in gusts that whirl. */
async function tumble(): Promise<{ w: World; bits: () => number[] }> {
  const w = await world();
  addFloor(w);
  const bodies = [
    box(1, 0.3, 0.7),
    sphere(0.4),
    { type: 'Cone', bottomRadius: 0.4, height: 1 },
  ].map(
    (geometry, i) =>
      addBody(w, { mass: 0.5, position: [0, 1 + 2 * i, 0], geometry: [geometry] }) as Body,
  );
  blow(w, 15, { gustiness: 0.7, turbulence: 0.4 }, { seed: 5 });
  const bits = (): number[] =>
    bodies.flatMap((body) => [...position(body), ...velocity(body), ...spin(body)]);
  return { w, bits };
}

fact('after going back and after a reset bodies are blown the same way, to the bit', async () => {
  const { w, bits } = await tumble();
  w.advance(0.7);
  const kept = w.snapshot();
  w.advance(0.8);
  const first = bits();
  w.restore(kept);
  w.advance(0.8);
  assert.deepEqual(bits(), first);
  w.reset();
  w.advance(0.7);
  w.advance(0.8);
  assert.deepEqual(bits(), first);
});

const resting = { rest: 'auto' };

fact('what stands in gusts falls asleep, and wakes when the wind is another', async () => {
  const { w, stone } = await onFloor(20, resting);
  const wind = w.add('WindPhysicsModel', { direction: [1, 0, 0], speed: 8, gustiness: 0.1 });
  const emitter = w.add('PointEmitter', { mass: 1 });
  blow(w, 0, {}, { physics: [wind], emitter });
  w.advance(4);
  assert.equal(stone.sleeping, true);
  // What is none of a wind wakes nobody.
  emitter.set('speed', 3);
  w.advance(0.1);
  assert.equal(stone.sleeping, true);
  wind.set('speed', 40);
  w.advance(0.5);
  assert.equal(stone.sleeping, false);
  above(position(stone)[0], 0.5, 'm');
});

fact('where a wind begins, what slept before it wakes', async () => {
  const { w, stone } = await onFloor(10, resting);
  w.advance(4);
  assert.equal(stone.sleeping, true);
  blow(w, 15);
  w.advance(0.5);
  above(position(stone)[0], 0.3, 'm');
});

for (const [how, end] of [
  ['ceases', (wind: Node) => wind.set('enabled', false)],
  ['is taken away', (wind: Node) => wind.remove()],
] as const)
  fact(`what it holds to a wall falls when it ${how}`, async () => {
    const w = await world({ gravity: [0, -1, 0], ...resting });
    w.add('CollisionCollection', { collidables: '*', frictionCoefficients: [1, 1] });
    addBody(w, { fixed: true, position: [1, 5, 0], geometry: [box(1, 10, 10)] });
    const leaf = addBody(w, { mass: 1, position: [0.45, 5, 0], geometry: [box(0.1, 1, 1)] });
    const wind = blow(w, 10);
    w.advance(4);
    assert.equal(leaf.sleeping, true);
    close(height(leaf), 5, 1e-2, 'm');
    end(wind);
    w.advance(1);
    below(height(leaf), 4.6, 'm');
  });

fact('what slept when a snapshot was taken sleeps on after going back', async () => {
  const { w, stone } = await onFloor(20, resting);
  const system = blow(w, 8);
  w.advance(4);
  const kept = w.snapshot();
  w.advance(0.5);
  system.set('pushes', false);
  w.step();
  w.restore(kept);
  w.advance(0.5);
  assert.equal(stone.sleeping, true);
});
