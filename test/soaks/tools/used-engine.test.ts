import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { gzipSync } from 'node:zlib';
import fc from 'fast-check';
import type { Engine } from '../../../physics-core/engine/engine.js';
import { editsPlan } from '../../fuzz/edits-plan.js';
import { plan, type Plan } from '../../fuzz/plan.js';
import { Scene } from '../../fuzz/scene.js';
import { usedGlue } from '../../../tools/build/engine/used-glue.js';
import { usedWasm } from '../../../tools/build/engine/used-wasm.js';
import { globSync } from '../../../tools/files.js';
import { engines, started, stateOf } from './engines.js';

const GLUE = 'node_modules/ammojs-typed/ammo/ammo.wasm.js';

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

test('it is a sixth of the whole, and its wasm, of which a server sends 292 kB, 157', () => {
  const glue = readFileSync(GLUE, 'utf8');
  assert.ok(usedGlue(glue).code.length < glue.length / 6);
  assert.ok(gzipSync(usedWasm()).length < 159_000);
});

/** Plays a plan in each, step by step. */
function compare(both: readonly Engine[], plan: Plan): void {
  const { gravity, level: accuracy } = plan;
  const worlds = both.map((engine) => started(engine, { gravity, accuracy }));
  const scenes = worlds.map((world) => new Scene(world, plan));
  for (let step = 0; step < plan.steps; step++) {
    for (const scene of scenes) scene.step(step, plan.edits);
    const [all, used] = worlds.map(stateOf);
    assert.equal(used, all, `step ${step} of ${JSON.stringify(plan)}`);
  }
  for (const world of worlds) world.destroy();
}

// Every node with random fields, every geometry, edits of all kinds while it runs, drags, rays, snapshots and removals.
test('150 random scenes move there as with all of Ammo, to the last bit', async () => {
  const both = await engines();
  const plans = fc.sample(fc.oneof(plan, editsPlan), { seed: 35, numRuns: 150 });
  for (const each of plans) compare(both, each);
});
