import { applyInertia } from '../../../../physics-core/dynamics/inertia.js';
import { PARTICLE } from '../../../../physics-core/effects/particles/cloud.js';
import { particles } from '../../../../physics-core/effects/particles/effects.js';
import type { World } from '../../../../physics-core/inside.js';
import type { ParticleSystemNode } from '../../../../physics-core/nodes/particles/particle-system-node.js';
import type { PhysicsNode } from '../../../../physics-core/nodes/node/node.js';
import {
  addBody,
  addFloor,
  addJoint,
  below,
  box,
  claim,
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
  type Vec3,
} from '../../helpers.js';

// What particles give to bodies, they have lost.

/** Of 0.5 kg each, one after another from -1 0 0. */
const shots = (
  w: World,
  fields: Record<string, unknown> = {},
  at: Vec3 = [-1, 0, 0],
): PhysicsNode =>
  w.add('ParticleSystem', {
    emitter: {
      type: 'PointEmitter',
      position: at,
      direction: [1, 0, 0],
      speed: 3,
      variation: 0,
      mass: 0.5,
    },
    maxParticles: 1,
    particleLifetime: 1000,
    particleSize: [0, 0],
    collides: true,
    pushes: true,
    friction: 0,
    ...fields,
  });

const place = (system: PhysicsNode): Vec3 => (system.get('positions') as Vec3[])[0]!;

/** m/s, over the seconds that follow. */
function speedOf(w: World, system: PhysicsNode, seconds = 0.5): Vec3 {
  const before = place(system);
  const passed = w.advance(seconds);
  return place(system).map((x, i) => (x - before[i]!) / passed) as Vec3;
}

const momentOf = (body: Body): Vec3 => applyInertia(body, spin(body));

fact('a ball that is hit straight goes on as two balls do, with each share of bounce', async () => {
  for (const bounce of [0, 0.5, 1]) {
    const w = await world(WEIGHTLESS);
    const ball = addBody(w, { mass: 2, geometry: [sphere(0.5)] });
    const system = shots(w, { bounce });
    w.advance(0.5);
    const after = speedOf(w, system);
    const speed = (0.5 * 3 * (1 + bounce)) / 2.5;
    close(velocity(ball), [speed, 0, 0], 1e-6);
    close(after, [3 - 4 * speed, 0, 0], 1e-5);
  }
});

fact(
  'what is hit off its centre turns, and no momentum is lost, with friction or without',
  async () => {
    for (const friction of [0, 0.4]) {
      const w = await world(WEIGHTLESS);
      const body = addBody(w, {
        mass: 2,
        orientation: [0, 0, 1, 0.4],
        geometry: [box(1, 0.6, 0.8)],
      });
      const system = shots(w, { bounce: 0.6, friction }, [-2, 0.15, 0.1]);
      w.advance(0.75);
      const body1 = { p: velocity(body).map((v) => 2 * v), l: momentOf(body), x: position(body) };
      const from = place(system);
      const p = speedOf(w, system).map((v) => 0.5 * v);
      close(
        body1.p.map((each, i) => each + p[i]!),
        [1.5, 0, 0],
        1e-5,
      );
      const about = (x: number[], m: number[]): number[] => [
        x[1]! * m[2]! - x[2]! * m[1]!,
        x[2]! * m[0]! - x[0]! * m[2]!,
        x[0]! * m[1]! - x[1]! * m[0]!,
      ];
      const [one, two] = [about(from, p), about(body1.x, body1.p)];
      close(
        body1.l.map((each, i) => each + one[i]! + two[i]!),
        about([0, 0.15, 0.1], [1.5, 0, 0]),
        1e-5,
      );
    }
  },
);

fact('a wheel that particles strike has the momentum that they lost, to a thousandth', async () => {
  const w = await world(WEIGHTLESS);
  const wheel = addBody(w, {
    mass: 3000,
    inertia: [1, 0, 0, 0, 1, 0, 0, 0, 2],
    geometry: [box(0.2, 4, 0.5)],
  });
  addJoint(w, 'SingleAxisHingeJoint', { body1: wheel, axis: [0, 0, 1] });
  const system = shots(w, { bounce: 0.5, particleSize: [0.02, 0.02] }, [-1, 1.5, 0]);
  w.advance(0.5);
  const turns = spin(wheel)[2];
  const lost = 0.5 * 3 - 0.5 * speedOf(w, system, 0.1)[0];
  close(2 * turns, -1.5 * lost, 1e-3 * 1.5 * lost);
  // By hand: both give way, the rim by r²/I.
  close(lost, (0.5 * 3 * 1.5) / (1 + (0.5 * 1.5 ** 2) / 2), 5e-3);
});

fact('what lies on a body presses it by its weight, and goes with it', async () => {
  const w = await world();
  const plate = addBody(w, {
    mass: 10,
    position: [0, 1, 0],
    geometry: [box(2, 0.2, 2)],
    useGlobalGravity: false,
  });
  // A hundred, a kilogram in all.
  const system = shots(w, {
    physics: [{ type: 'ForcePhysicsModel', force: [0, -0.098, 0] }],
    emitter: { type: 'ExplosionEmitter', position: [0, 1.1, 0], speed: 0, mass: 0.01 },
    maxParticles: 100,
    friction: 1,
  });
  w.advance(1);
  const fall = 9.8 / 11;
  close(velocity(plate)[1], -fall, 0.01);
  close(height(plate), 1 - fall / 2, 0.01);
  for (const [, y] of system.get('positions') as Vec3[]) close(y, height(plate) + 0.1, 0.01);
});

fact('who pushes nothing leaves bodies where they are, and so does what has no mass', async () => {
  for (const fields of [
    { pushes: false },
    { emitter: { type: 'PointEmitter', position: [-1, 0, 0], direction: [1, 0, 0], speed: 3 } },
  ]) {
    const w = await world(WEIGHTLESS);
    const ball = addBody(w, { mass: 2, geometry: [sphere(0.5)] });
    if (!('pushes' in fields)) claim(w, 'idle-force');
    shots(w, { ...fields, bounce: 1 });
    w.advance(1);
    close(velocity(ball), [0, 0, 0], 0);
  }
});

fact('a body that sleeps is woken by what strikes it', async () => {
  const w = await world({ rest: 'auto' });
  addFloor(w);
  const block = addBody(w, { position: [0, 0.5, 0], geometry: [box(1, 1, 1)] });
  w.advance(4);
  const slept = block.sleeping;
  shots(w, {
    bounce: 0,
    emitter: {
      type: 'PointEmitter',
      position: [-1, 0.5, 0],
      direction: [1, 0, 0],
      speed: 60,
      mass: 0.5,
    },
  });
  w.advance(0.1);
  close(slept && !block.sleeping ? 1 : 0, 1, 0);
});

/** Of all particles: momentum, and twice the energy. */
function sumsOf(w: World, system: PhysicsNode, mass: number): { p: Vec3; energy: number } {
  const { count, motion } = w.registry.get(particles).of(system as ParticleSystemNode)!.cloud;
  const sums = { p: [0, 0, 0] as Vec3, energy: 0 };
  for (let k = 0; k < count; k++)
    for (let i = 0; i < 3; i++) {
      const speed = motion[k * PARTICLE + 3 + i]!;
      sums.p[i]! += mass * speed;
      sums.energy += mass * speed ** 2;
    }
  return sums;
}

for (const [bounce, friction] of [
  [1, 0],
  [0.5, 0.5],
] as const)
  fact(
    `three hundred particles that strike a spinning box lose what it gets, with a bounce of ${bounce} and a friction of ${friction}`,
    async () => {
      const w = await world(WEIGHTLESS);
      const body = addBody(w, {
        mass: 2,
        angularVelocity: [1, 2, 3],
        geometry: [box(1, 0.6, 0.8)],
      });
      const mass = 0.01;
      const system = shots(w, {
        emitter: {
          type: 'ConeEmitter',
          position: [-1.5, 0, 0],
          direction: [1, 0, 0],
          angle: 0.2,
          speed: 8,
          mass,
        },
        maxParticles: 300,
        particleLifetime: 1,
        lifetimeVariation: 0,
        bounce,
        friction,
      });
      const energyOf = (): number => {
        const l = momentOf(body);
        const turning = spin(body).reduce((sum, speed, i) => sum + speed * l[i]!, 0);
        return turning + velocity(body).reduce((sum, speed) => sum + 2 * speed ** 2, 0);
      };
      // Most are born and have not come to it yet.
      w.advance(0.15);
      let before = sumsOf(w, system, mass);
      let bodyBefore = velocity(body);
      let energy = energyOf();
      for (let i = 0; i < 60; i++) {
        system.set('createParticles', false);
        w.step();
        const after = sumsOf(w, system, mass);
        const given = velocity(body).map((speed, k) => 2 * (speed - bodyBefore[k]!));
        close(
          given,
          before.p.map((p, k) => p - after.p[k]!),
          2e-6,
        );
        // What it gets in a step goes by its speed in that step.
        below(after.energy + energyOf(), (before.energy + energy) * (1 + 2e-3));
        [before, bodyBefore, energy] = [after, velocity(body), energyOf()];
      }
      below(1, velocity(body)[0] * 20);
    },
  );

fact(
  'what is thrown from a body pushes it back: a rocket flies, and who throws at itself stays',
  async () => {
    for (const [place, direction, speed] of [
      [[0, 0.6, 0], [0, 1, 0], -1],
      [[0, 0.3, 0], [0, -1, 0], 0],
    ] as const) {
      const w = await world(WEIGHTLESS);
      const body = addBody(w, { mass: 10, geometry: [box(1, 1, 1)] });
      // Above its top, or inside near to it: fifty of them, of 0.2 N s each.
      shots(w, {
        body,
        maxParticles: 100,
        particleLifetime: 2,
        bounce: 0,
        emitter: {
          type: 'PointEmitter',
          position: place,
          direction,
          speed: 2,
          variation: 0,
          mass: 0.1,
        },
      });
      w.advance(1);
      close(velocity(body)[1], speed, 0.04);
    }
  },
);

fact('what lies on a body that stands lies still, however many press on it', async () => {
  const w = await world();
  addFloor(w);
  addBody(w, { mass: 1, position: [0, 0.1, 0], geometry: [box(0.6, 0.2, 0.6)] });
  w.advance(0.2);
  const system = shots(w, {
    physics: [{ type: 'ForcePhysicsModel', force: [0, -0.098, 0] }],
    emitter: { type: 'ExplosionEmitter', position: [0.2, 0.21, 0], speed: 0, mass: 0.01 },
    maxParticles: 100,
    friction: 0.5,
  });
  w.advance(0.5);
  const before = system.get('positions') as Vec3[];
  w.advance(3);
  (system.get('positions') as Vec3[]).forEach((at, k) => close(at, before[k]!, 1e-3));
});

fact('a heap weighs what it weighs on what stands, and is lifted by it no less', async () => {
  const w = await world();
  addFloor(w);
  const block = addBody(w, { mass: 1, position: [0, 0.5, 0], geometry: [box(1, 1, 1)] });
  const system = shots(w, {
    physics: [{ type: 'ForcePhysicsModel', force: [0, -0.98, 0] }],
    emitter: { type: 'ExplosionEmitter', position: [0, 1, 0], speed: 0, mass: 0.1 },
    maxParticles: 100,
    friction: 0.5,
  });
  w.advance(0.5);
  // Before the floor answers, with the next step: of ten kilograms on one.
  close(velocity(block)[1], -9.8 * 10 * w.timeStep, 0.02);
  system.remove();
});

fact('a free body pressed by a heap gets all of its weight', async () => {
  const w = await world(WEIGHTLESS);
  const block = addBody(w, { mass: 1, geometry: [box(1, 1, 1)] });
  const system = shots(w, {
    physics: [{ type: 'ForcePhysicsModel', force: [0, -0.098, 0] }],
    emitter: { type: 'ExplosionEmitter', position: [0, 0.5, 0], speed: 0, mass: 0.01 },
    maxParticles: 100,
  });
  w.advance(0.5);
  const p = sumsOf(w, system, 0.01).p[1] + velocity(block)[1];
  close(p, -0.98 * 10 * 0.5, 0.02);
});

fact(
  'what is struck through its centre while it moves does not spin, and loses no energy',
  async () => {
    for (const speed of [0, 5, 50]) {
      const w = await world({ ...WEIGHTLESS, accuracy: 'game' });
      const ball = addBody(w, {
        mass: 2,
        position: [0, 0, 0],
        linearVelocity: [0, 0, speed],
        geometry: [sphere(0.2)],
      });
      const carrier = addBody(w, {
        position: [-1, 0, 0],
        linearVelocity: [0, 0, speed],
        geometry: [sphere(0.01)],
      });
      const system = shots(w, { body: carrier, bounce: 1, pushes: true }, [0.1, 0, 0]);
      w.advance(0.5);
      close(spin(ball), [0, 0, 0], 1e-3);
      close(velocity(ball)[0], (2 * 0.5 * 3) / 2.5, 1e-3);
      system.remove();
    }
  },
);
