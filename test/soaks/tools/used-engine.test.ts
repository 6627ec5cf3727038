import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import fc from 'fast-check';
import { stabilityCases } from '../../../lab/stability/cases/index.js';
import { fetchGlue, loadAmmo } from '../../../physics-core/engine/ammo.js';
import { Engine } from '../../../physics-core/engine/engine.js';
import { loadEngine, World } from '../../../physics-core/inside.js';
import { BodyNode } from '../../../physics-core/nodes/body/body.js';
import { editsPlan } from '../../fuzz/edits-plan.js';
import { plan, type Plan } from '../../fuzz/plan.js';
import { Scene } from '../../fuzz/scene.js';
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

/** One with a heap of its own. */
async function engineOf(wasm: Uint8Array<ArrayBuffer>): Promise<Engine> {
  const program = await WebAssembly.compile(wasm);
  return new Engine(await loadAmmo(await fetchGlue(), program), { program });
}

/** Ammo, and what pages have of it. With the code of all effects. */
async function engines(): Promise<[Engine, Engine]> {
  await loadEngine();
  return Promise.all([engineOf(new Uint8Array(readFileSync(WASM))), engineOf(usedWasm())]);
}

function started(engine: Engine, fields: Record<string, unknown>): World {
  const world = new World({ console: false });
  world.add('RigidBodyCollection', fields);
  world.start(engine);
  return world;
}

/** What there is to tell two runs apart by, to the last bit. */
const stateOf = (world: World): string =>
  JSON.stringify([...world.nodes].filter((node) => node instanceof BodyNode).map((body) => {
    const { p, q } = body.pose();
    return [p, q, [...world.bodies.velocityOf(body)]];
  }));

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

test('Bullet has the layout and the stages there that the core knows', async () => {
  for (const { heapTrusted, stages } of await engines())
    assert.deepEqual([heapTrusted, stages !== undefined], [true, true]);
});

// Every node with random fields, every geometry, edits of all kinds while it runs, drags, rays, snapshots and removals.
test('150 random scenes move there as with all of Ammo, to the last bit', async () => {
  const both = await engines();
  const plans = fc.sample(fc.oneof(plan, editsPlan), { seed: 35, numRuns: 150 });
  for (const each of plans) compare(both, each);
});

// Those that break engines: stacks, chains, machines, meshes, things that spin, edits of what is in touch.
test('so does each scene of the stability matrix, for a second', async () => {
  const both = await engines();
  for (const { id, scene, world: fields = {} } of stabilityCases) {
    const worlds = both.map((engine) => started(engine, fields));
    const plays = worlds.map((world) => scene(world));
    for (let frame = 0; frame < 60; frame++) {
      for (const [i, play] of plays.entries()) {
        play.before?.(frame / 60, frame);
        if (play.pass) play.pass();
        else worlds[i]!.advance(1 / 60);
        play.after?.();
      }
    }
    const [all, used] = worlds.map(stateOf);
    assert.equal(used, all, id);
    for (const world of worlds) world.destroy();
  }
});
