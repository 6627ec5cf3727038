import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createWorld } from '../../../../physics-core/create.js';
import { type World } from '../../../../physics-core/inside.js';
import type { PhysicsNode } from '../../../../physics-core/nodes/node/node.js';
import { codes, random, type Vec3 } from '../../helpers.js';

// Random systems among random bodies, with random edits: whatever is asked for, particles are somewhere, as many as may be.

const SCENES = 150;

/** Problems that what is asked for here may have. */
const EXPECTED = new Set([
  'idle-emitter',
  'idle-force',
  'mass-ratio',
  'initial-overlap',
  'lag',
  'too-fast',
  'out-of-range',
]);

type Draw = () => number;

const between = (draw: Draw, low: number, high: number): number => low + (high - low) * draw();
const one = <T>(draw: Draw, all: readonly T[]): T => all[Math.floor(draw() * all.length)]!;
const place = (draw: Draw, reach: number): Vec3 => [
  between(draw, -reach, reach),
  between(draw, -reach, reach),
  between(draw, -reach, reach),
];
/** Of any size, now and then of none. */
const sized = (draw: Draw, least: number, most: number): number =>
  draw() < 0.15 ? 0 : Math.exp(between(draw, Math.log(least), Math.log(most)));

const shape = (draw: Draw): Record<string, unknown> =>
  one(draw, [
    { type: 'Box', size: [sized(draw, 0.01, 3) + 0.01, 1, sized(draw, 0.01, 3) + 0.01] },
    { type: 'Sphere', radius: between(draw, 0.05, 1) },
    { type: 'Cylinder', radius: between(draw, 0.05, 1), height: between(draw, 0.05, 2) },
    { type: 'Cone', bottomRadius: between(draw, 0.05, 1), height: between(draw, 0.05, 2) },
    { type: 'Rectangle2D', size: [1, 2] },
    {
      type: 'ElevationGrid',
      xDimension: 3,
      zDimension: 3,
      height: place(draw, 1).concat(place(draw, 1), place(draw, 1)),
    },
  ]);

const emitter = (draw: Draw): Record<string, unknown> => ({
  ...one(draw, [
    { type: 'PointEmitter', position: place(draw, 2), direction: place(draw, 1) },
    { type: 'PointEmitter', direction: [0, 0, 0] },
    { type: 'ConeEmitter', position: place(draw, 2), angle: between(draw, 0, Math.PI) },
    { type: 'ExplosionEmitter', position: place(draw, 1) },
    { type: 'PolylineEmitter', coord: [...place(draw, 2), ...place(draw, 2), ...place(draw, 2)] },
    { type: 'SurfaceEmitter', surface: shape(draw) },
    { type: 'SurfaceEmitter' },
    {
      type: 'VolumeEmitter',
      internal: draw() < 0.5,
      coord: [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1],
      coordIndex: [0, 2, 1, -1, 0, 1, 3, -1, 0, 3, 2, -1, 1, 2, 3, -1],
    },
  ]),
  speed: sized(draw, 1e-3, 1e3),
  variation: one(draw, [0, 0.25, 1, 3]),
  mass: sized(draw, 1e-6, 1e3),
  surfaceArea: sized(draw, 1e-6, 1e3),
});

const model = (draw: Draw): Record<string, unknown> =>
  one(draw, [
    { type: 'ForcePhysicsModel', force: place(draw, sized(draw, 1e-4, 1e4)) },
    {
      type: 'WindPhysicsModel',
      direction: place(draw, 1),
      speed: sized(draw, 1e-2, 1e3),
      gustiness: one(draw, [0, 0.1, 2]),
      turbulence: one(draw, [0, draw()]),
    },
    { type: 'BoundedPhysicsModel', geometry: { type: 'Box', size: [6, 6, 6] } },
    { type: 'BoundedPhysicsModel', geometry: shape(draw) },
  ]);

const fields = (draw: Draw): Record<string, unknown> => ({
  emitter: emitter(draw),
  physics: Array.from({ length: Math.floor(draw() * 4) }, () => model(draw)),
  maxParticles: Math.floor(sized(draw, 1, 300)),
  particleLifetime: sized(draw, 1e-4, 1e3),
  lifetimeVariation: draw(),
  particleSize: [sized(draw, 1e-3, 1), sized(draw, 1e-3, 1)],
  collides: draw() < 0.7,
  pushes: draw() < 0.5,
  bounce: one(draw, [0, 0.5, 1]),
  friction: one(draw, [0, 0.5, 2]),
  damping: sized(draw, 1e-6, 1e6),
  seed: Math.floor(draw() * 1000),
});

function build(w: World, draw: Draw): { bodies: PhysicsNode[]; systems: PhysicsNode[] } {
  w.add('RigidBody', {
    fixed: true,
    position: [0, -3, 0],
    geometry: [{ type: 'Box', size: [20, 1, 20] }],
  });
  const bodies = Array.from({ length: 4 }, () =>
    w.add('RigidBody', {
      position: place(draw, 4),
      linearVelocity: place(draw, 5),
      angularVelocity: place(draw, 5),
      mass: sized(draw, 1e-2, 1e3) + 0.01,
      geometry: [
        one(draw, [
          { type: 'Box', size: [1, 0.5, 0.7] },
          { type: 'Sphere', radius: 0.4 },
          { type: 'Cone', bottomRadius: 0.3, height: 0.8 },
          { type: 'Rectangle2D', size: [0.5, 0.8] },
        ]),
      ],
    }),
  );
  const systems = Array.from({ length: 1 + Math.floor(draw() * 2) }, () =>
    w.add('ParticleSystem', { ...fields(draw), body: draw() < 0.3 ? one(draw, bodies) : null }),
  );
  return { bodies, systems };
}

function edit(system: PhysicsNode, draw: Draw): void {
  const [name, value] = one(draw, Object.entries(fields(draw)));
  system.set(name, value);
}

function check(systems: readonly PhysicsNode[], scene: number): void {
  for (const system of systems) {
    const places = system.get('positions') as Vec3[];
    assert.equal(system.get('count'), places.length);
    for (const at of places)
      assert.ok(at.every(Number.isFinite), `scene ${scene}: ${at.join(' ')}`);
  }
}

const whereabouts = (bodies: readonly PhysicsNode[], systems: readonly PhysicsNode[]) => [
  ...systems.map((system) => system.get('positions')),
  ...bodies.map((body) => [body.get('position'), body.get('linearVelocity')]),
];

test('random systems have finite particles, no more than may live, and go back to the bit', async () => {
  for (let scene = 0; scene < SCENES; scene++) {
    const draw = random(scene * 7919 + 1);
    const w = await createWorld({
      accuracy: one(draw, ['game', 'standard', 'fine']),
      rest: 'never',
    });
    const { bodies, systems } = build(w, draw);
    for (let i = 0; i < 6; i++) {
      w.step(5);
      check(systems, scene);
      for (const system of systems)
        assert.ok((system.get('count') as number) <= (system.get('maxParticles') as number));
      if (draw() < 0.1) one(draw, bodies).remove();
      if (draw() < 0.5) edit(one(draw, systems), draw);
    }
    const kept = w.snapshot();
    w.step(10);
    const first = whereabouts(bodies, systems);
    w.restore(kept);
    w.step(10);
    assert.deepEqual(whereabouts(bodies, systems), first, `scene ${scene}`);
    for (const code of codes(w)) assert.ok(EXPECTED.has(code), `scene ${scene}: ${code}`);
    w.destroy();
  }
});
