import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { createWorld, type World } from '../../../physics-core/inside.js';
import { usedGlue } from '../../../tools/engine/used-glue.js';
import { usedWasm } from '../../../tools/engine/used-wasm.js';
import { globSync } from '../../../tools/files.js';

const GLUE = 'node_modules/ammojs-typed/ammo/ammo.wasm.js';
const WASM = 'node_modules/ammojs-typed/ammo/ammo.wasm.wasm';

/** What the core takes from Ammo by name. */
const named = (): Set<string> =>
  new Set(
    globSync('physics-core/**/*.ts').flatMap((file) =>
      [...readFileSync(file, 'utf8').matchAll(/\bammo\.(bt\w+|\w+Callback|DebugDrawer)\b/g)].map(
        ([, name]) => name!,
      ),
    ),
  );

test('the glue of pages still makes each class that the core names, with what a body is asked', () => {
  const { code } = usedGlue(readFileSync(GLUE, 'utf8'));
  const [, body] = /b\.btRigidBody=([\w$]+)/.exec(code)!;
  for (const name of named()) assert.ok(code.includes(`b.${name}=`), name);
  for (const method of ['setLinearVelocity', 'setMassProps'])
    assert.ok(code.includes(`${body}.prototype.${method}=`), method);
  assert.ok(code.includes('.prototype.get_m_closestHitFraction='), 'what rays answer');
  assert.ok(!code.includes('.prototype.CreateRope='), 'nobody calls it');
});

test('it and its wasm are at least a seventh smaller than all of Ammo', () => {
  const glue = readFileSync(GLUE, 'utf8');
  assert.ok(usedGlue(glue).code.length < glue.length / 2);
  assert.ok(usedWasm().length < (readFileSync(WASM).length * 6) / 7);
});

/** Boxes, a mesh and a chain that fall on a floor, for two seconds. */
async function played(wasmBinary: Uint8Array): Promise<World> {
  const world = await createWorld({ gravity: [0, -9.8, 0], wasmBinary });
  world.add('RigidBody', { fixed: true, geometry: [{ type: 'Box', size: [20, 1, 20] }] });
  const cone = { type: 'Cone', bottomRadius: 0.5, height: 1 };
  const shapes = [{ type: 'Box' }, { type: 'Sphere' }, cone, { type: 'Cylinder' }];
  const bodies = shapes.map((geometry, i) =>
    world.add('RigidBody', { position: [i * 1.7, 3 + i, 0.1 * i], geometry: [geometry] }),
  );
  world.add('BallJoint', { body1: bodies[0], body2: bodies[1], anchorPoint: [0.8, 3.5, 0] });
  world.advance(2);
  return world;
}

test('with it everything moves as with all of Ammo, to the last bit', async () => {
  const [all, used] = await Promise.all([played(readFileSync(WASM)), played(usedWasm())]);
  assert.deepEqual(used.snapshot(), all.snapshot());
});
