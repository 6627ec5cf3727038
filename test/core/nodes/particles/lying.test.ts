import assert from 'node:assert/strict';
import { Bounces } from '../../../../physics-core/effects/particles/bounces.js';
import type { World } from '../../../../physics-core/inside.js';
import type { PhysicsNode } from '../../../../physics-core/nodes/node/node.js';
import { addBody, addFloor, below, box, fact, world, type Body, type Vec3 } from '../../helpers.js';

// What lies is not asked again where nothing near it is other than it was.

const rain = (w: World, fields: Record<string, unknown> = {}): PhysicsNode =>
  w.add('ParticleSystem', {
    emitter: {
      type: 'PolylineEmitter',
      coord: [-2, 2, 0, 2, 2, 0.3],
      direction: [0, -1, 0],
      speed: 1,
      mass: 0.001,
    },
    physics: [{ type: 'ForcePhysicsModel', force: [0, -0.0098, 0] }],
    maxParticles: 200,
    particleLifetime: 20,
    particleSize: [0.05, 0.05],
    collides: true,
    ...fields,
  });

const placesOf = (system: PhysicsNode): Vec3[] => system.get('positions') as Vec3[];

/** Runs with all asked again in each step. */
async function askingAll(run: () => Promise<Vec3[]>): Promise<Vec3[]> {
  const { isCalm } = Bounces.prototype;
  Bounces.prototype.isCalm = () => false;
  try {
    return await run();
  } finally {
    Bounces.prototype.isCalm = isCalm;
  }
}

/** What is done to a world in which particles lie on the floor and on a box. */
const deeds: Record<string, (w: World, floor: Body, crate: Body) => void> = {
  nothing: () => {},
  'a ball rolls through them': (w) =>
    addBody(w, {
      position: [-4, 0.3, 0],
      linearVelocity: [4, 0, 0],
      geometry: [{ type: 'Sphere', radius: 0.3 }],
    }),
  'the box goes': (_, __, crate) => crate.remove(),
  'the box jumps away': (_, __, crate) => crate.teleport([9, 5, 0]),
  'the box is kicked': (_, __, crate) => crate.applyImpulse([1, 0, 0]),
  'the floor is put lower': (_, floor) => floor.set('position', [0, -0.6, 0]),
  'the floor is tilted': (_, floor) => floor.set('orientation', [0, 0, 1, 0.2]),
  'the floor goes': (_, floor) => floor.remove(),
  'the level changes': (w) => w.set('accuracy', 'fine'),
};

for (const [what, deed] of Object.entries(deeds))
  fact(`what lies goes on as if it were asked in each step, to the bit: ${what}`, async () => {
    const run = async (): Promise<Vec3[]> => {
      const w = await world();
      const floor = addFloor(w);
      const crate = addBody(w, { position: [0, 0.4, 0], geometry: [box(0.8, 0.8, 0.8)] });
      const system = rain(w);
      w.step(360);
      deed(w, floor, crate);
      w.step(120);
      return placesOf(system);
    };
    const places = await run();
    assert.ok(places.length > 30);
    assert.deepEqual(places, await askingAll(run));
  });

fact('what lies is looked at by nobody, until something comes', async () => {
  const w = await world();
  addFloor(w);
  rain(w);
  w.step(1200);
  const { follow } = Bounces.prototype;
  let asked = 0;
  Bounces.prototype.follow = function (...args) {
    asked++;
    return follow.apply(this, args);
  };
  try {
    w.step(10);
    // Ten fall on it in a second, and are asked until they lie.
    below(asked, 50, 'times in ten steps');
  } finally {
    Bounces.prototype.follow = follow;
  }
});
