// No world is made by `createWorld` before the first fact is over: that has the code of dense snapshots come.
import assert from 'node:assert/strict';
import { chunks, loadBullet, World } from '../../../../physics-core/inside.js';
import { dense } from '../../../../physics-core/world/snapshot/dense.js';
import { codes, fact } from '../../../core/helpers.js';

const COUNT = 40;

/** Threads have it come. */
const WITHOUT = chunks.filter(({ name }) => name !== 'thread');

const stateOf = ({ bodies }: World): number[] =>
  [...bodies].flatMap((body) => [
    ...body.readPose(new Float64Array(7)),
    ...bodies.velocityOf(body),
  ]);

function runOf(world: World): number[][] {
  return Array.from({ length: 10 }, () => (world.step(), stateOf(world)));
}

async function heap(): Promise<World> {
  const [engine] = await Promise.all([loadBullet(), ...WITHOUT.map((chunk) => chunk.load())]);
  const world = new World();
  world.add('RigidBody', { fixed: true, geometry: [{ type: 'Box', size: [20, 1, 20] }] });
  for (let i = 0; i < COUNT; i++)
    world.add('RigidBody', {
      position: [(i % 4) * 0.55, 0.8 + Math.floor(i / 4) * 0.6, (i % 3) * 0.1],
      geometry: [{ type: 'Box', size: [0.5, 0.5, 0.5] }],
    });
  world.start(engine);
  world.step(60);
  return world;
}

const bytesOf = (value: unknown): number => JSON.stringify(value).length;

fact('the first snapshot is written without its code, the next ones in half of that', async () => {
  const world = await heap();
  assert.equal(dense.here, false);
  const plain = JSON.parse(JSON.stringify(world.snapshot())) as ReturnType<World['snapshot']>;
  assert.equal(typeof plain.bodies, 'object');
  world.restore({ ...plain, bodies: 'of a page that had its code' as never });
  assert.equal(world.step(5), 0, 'time stands still until it is here');
  await dense.load();
  await new Promise((done) => setTimeout(done));
  assert.deepEqual(codes(world), ['bad-value']);
  assert.ok(world.step() > 0, 'and goes on');
  world.restore(plain);
  const short = world.snapshot();
  assert.equal(typeof short.bodies, 'string');
  assert.ok(2 * bytesOf(short) < bytesOf(plain), `${bytesOf(short)} of ${bytesOf(plain)} bytes`);
  const seen = runOf(world);
  const { created } = world.stats;
  for (const one of [plain, short]) {
    world.restore(one);
    assert.equal(world.stats.created, created, 'nothing is made anew');
    assert.deepEqual(runOf(world), seen);
  }
  world.destroy();
});
