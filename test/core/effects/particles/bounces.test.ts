import { conjugate, rotate, subtract } from '../../../../physics-core/base/math.js';
import { particles } from '../../../../physics-core/effects/particles/effects.js';
import type { ParticleSystemNode } from '../../../../physics-core/nodes/particles/particle-system-node.js';
import type { World } from '../../../../physics-core/inside.js';
import type { PhysicsNode } from '../../../../physics-core/nodes/node/node.js';
import {
  addBody,
  addFloor,
  below,
  box,
  close,
  fact,
  height,
  sphere,
  WEIGHTLESS,
  world,
  type Vec3,
} from '../../helpers.js';

// Particles that meet bodies, by closed forms.

const G = 9.8;

/** One particle of 1 g, thrown from a place. */
const thrown = (
  w: World,
  position: Vec3,
  velocity: Vec3,
  fields: Record<string, unknown> = {},
): PhysicsNode =>
  w.add('ParticleSystem', {
    emitter: {
      type: 'PointEmitter',
      position,
      direction: velocity,
      speed: Math.hypot(...velocity),
      variation: 0,
      mass: 0.001,
    },
    physics: [{ type: 'ForcePhysicsModel', force: [0, -G * 0.001, 0] }],
    maxParticles: 1,
    particleLifetime: 1000,
    particleSize: [0, 0],
    collides: true,
    friction: 0,
    ...fields,
  });

const place = (system: PhysicsNode): Vec3 => (system.get('positions') as Vec3[])[0]!;

for (const accuracy of ['game', 'standard', 'precise']) {
  fact(
    `a particle bounces at its own time, to the height that the law says, at ${accuracy}`,
    async () => {
      const w = await world({ accuracy });
      addFloor(w);
      const system = thrown(w, [0, 1, 0], [0, -1e-9, 0], { bounce: 0.7 });
      // It falls for √(2h/g), and rises for as long times the bounce.
      const fall = Math.sqrt(2 / G);
      let highest = 0;
      while (w.time < fall * 1.1) w.step();
      while (w.time < fall * 2.3) {
        w.step();
        highest = Math.max(highest, place(system)[1]);
      }
      close(highest, 0.7 ** 2, 2e-3);
    },
  );

  fact(`what does not bounce lies where it fell, and stays there, at ${accuracy}`, async () => {
    const w = await world({ accuracy });
    addFloor(w);
    const system = thrown(w, [0.2, 0.5, 0.3], [0, -1e-9, 0]);
    w.advance(1);
    close(place(system), [0.2, 0, 0.3], 1e-6);
    w.advance(2);
    close(place(system), [0.2, 0, 0.3], 1e-6);
  });

  fact(`what slides is stopped by friction after v² / 2µg, at ${accuracy}`, async () => {
    const w = await world({ accuracy });
    addFloor(w);
    const system = thrown(w, [0, 0, 0], [2, 0, 0], { friction: 0.4 });
    w.advance(2);
    const [x, y] = place(system);
    close(x, 4 / (2 * 0.4 * G), 2e-3);
    close(y, 0, 1e-6);
  });
}

fact('what bounces without loss keeps its energy for a minute, at game', async () => {
  const w = await world({ accuracy: 'game' });
  addFloor(w);
  const system = thrown(w, [0, 1, 0], [0, -1e-9, 0], { bounce: 1 });
  w.advance(58);
  let highest = 0;
  for (let i = 0; i < 120; i++) {
    w.step();
    highest = Math.max(highest, place(system)[1]);
  }
  // Steps see the summit within g dt² / 8.
  close(highest, 1, 1e-3);
});

fact('on a slope it slides where friction is too little, and as fast as the law says', async () => {
  const w = await world();
  const slope = 0.5;
  addBody(w, {
    fixed: true,
    orientation: [0, 0, 1, -slope],
    geometry: [box(40, 1, 4)],
  });
  const top: Vec3 = [0.5 * Math.sin(slope), 0.5 * Math.cos(slope), 0];
  const along: Vec3 = [Math.cos(slope), -Math.sin(slope), 0];
  const slides = thrown(w, top, [0, 0, 0], { friction: 0.3 });
  const holds = thrown(w, top, [0, 0, 0], { friction: 0.6 });
  w.advance(1);
  const way = (G * (Math.sin(slope) - 0.3 * Math.cos(slope))) / 2;
  close(place(slides), [top[0] + along[0] * way, top[1] + along[1] * way, 0], 2e-3);
  close(place(holds), top, 1e-6);
});

fact('at 100 m/s it goes through no plate of a millimetre', async () => {
  const w = await world({ accuracy: 'game' });
  addBody(w, { fixed: true, position: [1, 0, 0], geometry: [box(0.001, 4, 4)] });
  const system = thrown(w, [0, 0, 0], [100, 0, 0], { physics: [], bounce: 1 });
  w.advance(0.1);
  // There and back again: 10 m in all.
  close(place(system)[0], 0.9995 - (10 - 0.9995), 1e-6);
});

fact(
  'at 100 m/s and in its weight it goes through no plate of a millimetre, wherever it meets it',
  async () => {
    const w = await world({ accuracy: 'game' });
    addBody(w, { fixed: true, position: [10, 0, 0], geometry: [box(0.001, 40, 40)] });
    addBody(w, { fixed: true, position: [5, -2.5, 0], geometry: [box(40, 1, 40)] });
    const system = w.add('ParticleSystem', {
      emitter: { type: 'ConeEmitter', direction: [1, 0, 0], angle: 0.2, speed: 100, mass: 0.001 },
      physics: [{ type: 'ForcePhysicsModel', force: [0, -0.0098, 0] }],
      maxParticles: 500,
      particleLifetime: 0.5,
      particleSize: [0, 0],
      collides: true,
      bounce: 0.5,
    });
    for (let i = 0; i < 60; i++) {
      w.step();
      for (const [x] of system.get('positions') as Vec3[]) below(x, 10);
    }
  },
);

fact('a closed box that spins keeps what flies in it, thin as it is', async () => {
  const w = await world({ accuracy: 'game', gravity: [0, 0, 0] });
  const thin = 0.002;
  const half = 1 + thin / 2;
  const long = 2 + 2 * thin;
  const side = (translation: Vec3, size: Vec3) => ({
    type: 'CollidableOffset',
    translation,
    collidable: { type: 'CollidableShape', shape: { type: 'Box', size } },
  });
  const drum = addBody(w, {
    mass: 1e6,
    angularVelocity: [0, 0, 5],
    geometry: [-half, half].flatMap((at) => [
      side([at, 0, 0], [thin, long, long]),
      side([0, at, 0], [long, thin, long]),
      side([0, 0, at], [long, long, thin]),
    ]),
  });
  const system = w.add('ParticleSystem', {
    emitter: { type: 'ExplosionEmitter', speed: 4, variation: 1, mass: 1 },
    physics: [{ type: 'ForcePhysicsModel', force: [0, -9.8, 0] }],
    maxParticles: 150,
    particleLifetime: 1000,
    particleSize: [0, 0],
    collides: true,
    bounce: 0.5,
  });
  w.advance(3);
  const { p, q } = drum.pose();
  for (const at of system.get('positions') as Vec3[]) {
    const inside = rotate(conjugate(q), subtract(at, p));
    below(Math.max(...inside.map(Math.abs)), 1 + 1e-3);
  }
});

fact('drag and friction bring it to a stand, and never back', async () => {
  for (const damping of [50, 200, 1000]) {
    const w = await world({ accuracy: 'game' });
    addFloor(w);
    const system = thrown(w, [0, 0, 0], [2, 0, 0], { friction: 5, damping });
    let before = 0;
    for (let i = 0; i < 30; i++) {
      w.step();
      const [x] = place(system);
      below(before, x + 1e-9);
      before = x;
    }
  }
});

fact(
  'a body that was moved while nothing could meet it hits nothing when something can',
  async () => {
    const w = await world(WEIGHTLESS);
    const block = addBody(w, { fixed: true, position: [-3, 0, 0], geometry: [box(1, 1, 1)] });
    const system = thrown(w, [0, 0, 0], [0, 0, 0], { physics: [], collides: true });
    w.step();
    system.set('collides', false);
    for (let i = 0; i < 4; i++) {
      w.advance(0.5);
      block.set('position', [-3 + 0.6 * (i + 1), 0, 0]);
    }
    w.advance(0.5);
    system.set('collides', true);
    w.advance(0.5);
    close(place(system), [0, 0, 0], 0.11);
  },
);

fact('a body that comes takes it along, twice as fast as itself where it bounces', async () => {
  for (const [bounce, speed] of [
    [0, 3],
    [1, 6],
  ] as const) {
    const w = await world(WEIGHTLESS);
    addBody(w, {
      position: [-2, 0, 0],
      linearVelocity: [3, 0, 0],
      mass: 1e6,
      geometry: [box(1, 1, 1)],
    });
    const system = thrown(w, [0, 0, 0], [0, 0, 0], { physics: [], bounce });
    // The face meets it after half a second.
    w.advance(1.5);
    close(place(system), [speed, 0, 0], 0.02);
  }
});

fact('balls that are met as wide as they are drawn lie on the ground with their rim', async () => {
  const w = await world();
  addFloor(w);
  const system = thrown(w, [0, 0.5, 0], [0, -1e-9, 0], { particleSize: [0.1, 0.2] });
  w.advance(1.5);
  close(place(system), [0, 0.05, 0], 1e-6);
});

fact('in a corner it comes to rest, and nowhere out of it', async () => {
  const w = await world();
  addFloor(w);
  addBody(w, { fixed: true, position: [1.5, 1, 0], geometry: [box(1, 4, 4)] });
  const system = thrown(w, [0, 0.5, 0], [4, 0, 0], { friction: 0.5 });
  w.advance(3);
  const [x, y, z] = place(system);
  close(y, 0, 1e-6);
  close(z, 0, 1e-6);
  below(x, 1 + 1e-6);
});

fact('what is born inside a body is on its surface after a step', async () => {
  const w = await world(WEIGHTLESS);
  addBody(w, { fixed: true, geometry: [sphere(1)] });
  const system = thrown(w, [0.4, 0, 0], [0, 0, 0], { physics: [] });
  w.step();
  close(place(system), [1, 0, 0], 1e-6);
});

fact('it goes through bodies where it does not collide', async () => {
  const w = await world();
  addFloor(w);
  const system = thrown(w, [0, 0.5, 0], [0, 0, 0], { collides: false });
  w.advance(1);
  close(place(system)[1], 0.5 - G / 2, 1e-9);
});

const bounded = (geometry: unknown): unknown => ({ type: 'BoundedPhysicsModel', geometry });

fact(
  'within walls it goes to and fro, as fast as it came, whether bodies are met or not',
  async () => {
    for (const collides of [false, true]) {
      const w = await world(WEIGHTLESS);
      const system = thrown(w, [0, 0, 0], [3, 0, 0], {
        collides,
        physics: [bounded({ type: 'Box', size: [2, 2, 2] })],
      });
      // 1 m there, 2 m back, and 1.5 m there again.
      w.advance(1.5);
      close(place(system), [0.5, 0, 0], 1e-4);
    }
  },
);

fact('walls hold all of a thousand particles, at any speed', async () => {
  const w = await world(WEIGHTLESS);
  const system = w.add('ParticleSystem', {
    emitter: { type: 'ExplosionEmitter', speed: 30, variation: 1, mass: 1 },
    physics: [bounded({ type: 'Sphere', radius: 1 })],
    maxParticles: 1000,
    particleLifetime: 1e4,
    particleSize: [0, 0],
  });
  w.advance(5);
  const places = system.get('positions') as Vec3[];
  for (const at of places) below(Math.hypot(...at), 1 + 1e-6);
  close(places.length, 1000, 0);
});

fact('walls with gaps let go what finds them; without geometry there are none', async () => {
  for (const geometry of [null, { type: 'Rectangle2D', size: [1, 1] }]) {
    const w = await world(WEIGHTLESS);
    const system = thrown(w, [2, 0, -1], [0, 0, 3], {
      collides: false,
      physics: [bounded(geometry)],
    });
    w.advance(1);
    close(place(system), [2, 0, 2], 1e-9);
  }
});

fact('a body before a wall is met first, and a wall before a body', async () => {
  for (const [wall, end] of [
    [1.5, -1],
    [0.5, 0],
  ] as const) {
    const w = await world(WEIGHTLESS);
    addBody(w, { fixed: true, position: [1.5, 0, 0], geometry: [box(1, 1, 1)] });
    const system = thrown(w, [0, 0, 0], [3, 0, 0], {
      bounce: 1,
      physics: [bounded({ type: 'Box', size: [2 * wall, 20, 20] })],
    });
    // 1 m to the body or half a metre to the wall, then back to the other side.
    w.advance(1);
    close(place(system)[0], end, 1e-4);
  }
});

fact(
  'a lift carries what lies on it, and what is held between it and a wall beside it',
  async () => {
    for (const x of [0, 0.99]) {
      const w = await world(WEIGHTLESS);
      const lift = addBody(w, { mass: 1e6, linearVelocity: [0, 2, 0], geometry: [box(2, 1, 4)] });
      addBody(w, { fixed: true, position: [1.501, 2, 0], geometry: [box(1, 6, 4)] });
      const system = thrown(w, [x, 0.6, 0], [0.5, 0, 0], {
        friction: 0.9,
        particleSize: [0.01, 0.01],
      });
      w.advance(1);
      close(place(system)[1], height(lift) + 0.505, 1e-3);
      below(place(system)[0], 0.996 + 1e-6);
    }
  },
);

fact('between walls and in a ball nothing is lost in a minute, wherever it bounces', async () => {
  for (const geometry of [
    { type: 'Box', size: [2, 2, 2] },
    { type: 'Sphere', radius: 1 },
  ]) {
    const w = await world({ accuracy: 'game' });
    const system = thrown(w, [0.1, 0.2, 0.3], [3, 1, 2], {
      collides: false,
      physics: [{ type: 'ForcePhysicsModel', force: [0, -0.0098, 0] }, bounded(geometry)],
    });
    const energy = (): number => {
      const { motion } = w.registry.get(particles).of(system as ParticleSystemNode)!.cloud;
      const [, y, , u, v, t] = motion as unknown as number[];
      return (u! ** 2 + v! ** 2 + t! ** 2) / 2 + G * y!;
    };
    w.step();
    const before = energy();
    w.advance(60);
    close(energy(), before, 0.01);
  }
});
