import assert from 'node:assert/strict';
import type { World } from '../../../../physics-core/inside.js';
import { addBody, box, fact, world, type Node } from '../../helpers.js';
import { flat, places } from '../deformables/helpers.js';
import { addSea, THICK } from './helpers.js';

interface Told {
  of: string;
  event: string;
  water: number;
  depth: number;
  speed: number;
}

function listen(...nodes: Node[]): Told[] {
  const told: Told[] = [];
  for (const node of nodes)
    for (const event of ['waterenter', 'waterleave'])
      node.on(event, (detail) => {
        const { water, depth, speed } = detail as { water: Node; depth: number; speed: number };
        told.push({ of: node.type.name, event, water: water.id, depth, speed });
      });
  return told;
}

/** A jelly, a cloth and a rope above the water, coarse ones, which cost little. */
function scene(w: World): Node[] {
  return [
    w.add('SoftBody', {
      mass: 2,
      youngsModulus: 2e4,
      damping: 1,
      geometry: { ...box(0.4, 0.1, 0.1), translation: [0, 0.1, 0] },
    }),
    w.add('Cloth', {
      mass: 0.1,
      thickness: 0.001,
      damping: 1,
      geometry: { ...flat(3, 0.5, 0.1), translation: [2, 0, 0] },
    }),
    w.add('Rope', {
      points: [
        [4, 0.1, 0],
        [5, 0.1, 0],
      ],
      segments: 6,
      mass: 0.1,
      damping: 1,
    }),
  ];
}

const state = (nodes: readonly Node[]): number[] => nodes.flatMap((node) => places(node).flat());

fact('what gives way tells when it comes into water, and when it leaves', async () => {
  const w = await world();
  const sea = addSea(w, THICK);
  const nodes = scene(w);
  const news = listen(...nodes);
  w.advance(0.5);
  assert.deepEqual(
    news
      .slice(0, 3)
      .map(({ of, event, water }) => [of, event, water === sea.id])
      .sort(),
    ['Cloth', 'Rope', 'SoftBody'].map((of) => [of, 'waterenter', true]),
  );
  for (const { depth, speed } of news.slice(0, 3))
    assert.ok(depth > 0 && depth < 0.1 && speed > 0.2, `${depth} m deep, at ${speed} m/s`);
  sea.set('position', [0, -300, 0]);
  w.step(2);
  assert.deepEqual(
    news.slice(-3).map(({ event }) => event),
    ['waterleave', 'waterleave', 'waterleave'],
  );
});

fact('water that goes is left by what gives way', async () => {
  const w = await world();
  const sea = addSea(w, THICK);
  const nodes = scene(w);
  const news = listen(...nodes);
  w.advance(0.5);
  sea.remove();
  w.step(2);
  assert.deepEqual(
    news.slice(-3).map(({ event }) => event),
    ['waterleave', 'waterleave', 'waterleave'],
  );
});

fact('put back to before, all that swims goes on to the same bits', async () => {
  const w = await world();
  addSea(w, { flow: [0.3, 0, 0] });
  const nodes = scene(w);
  const float = addBody(w, { mass: 2, position: [4, 0, 0], geometry: [box(0.2)] });
  w.add('SoftBodyAttachment', { softBody: nodes[2], index: 0, body: float, position: [0, 0, 0] });
  const news = listen(...nodes);
  for (const before of [0.05, 0.1, 0.3]) {
    w.advance(before);
    const snapshot = w.snapshot();
    const told = news.length;
    w.advance(0.3);
    const first = state(nodes);
    const news1 = news.splice(told);
    w.restore(snapshot);
    w.advance(0.3);
    assert.deepEqual(state(nodes), first);
    assert.deepEqual(news.splice(told), news1);
    w.restore(snapshot);
  }
  w.reset();
  news.length = 0;
  w.advance(0.3);
  assert.ok(news.length >= 3, 'all come in again');
});

fact('what floats calmly sleeps until the water changes', async () => {
  const w = await world({ rest: 'auto' });
  const sea = addSea(w, { damping: 4 });
  const nodes = scene(w);
  const moves = (): number[] => nodes.map((node) => (node as never as { moves: number }).moves);
  w.advance(12);
  const before = moves();
  w.step(3);
  assert.deepEqual(moves(), before, 'asleep');
  sea.set('density', 1100);
  w.step(3);
  moves().forEach((now, i) => assert.ok(now > before[i]!, `${nodes[i]!.type.name} sleeps`));
});

fact('what is known of it says what it displaces, and why it floats', async () => {
  const w = await world();
  const sea = addSea(w, THICK);
  const nodes = scene(w);
  const ask = async (node: Node) =>
    ((await w.ask('explain', node as never)) as { bullet?: Record<string, never> }).bullet;
  assert.equal(await ask(nodes[0]!), undefined);
  w.advance(3);
  const { water } = (await ask(nodes[2]!))! as never as { water: Record<string, unknown> };
  assert.match(String(water.why), /floats/);
  assert.equal((await ask(sea))!.softBodies, 3);
});

fact('one that is taken out of the water, or out of the world, is no more in it', async () => {
  const w = await world();
  const sea = addSea(w, THICK);
  const nodes = scene(w);
  w.advance(0.5);
  for (const node of nodes) node.remove();
  w.step();
  const { bullet } = (await w.ask('explain', sea as never)) as { bullet: Record<string, number> };
  assert.equal(bullet.softBodies, 0);
  assert.equal(bullet.displaced, 0);
});

fact('what swims rides up and down on waves', async () => {
  const w = await world();
  w.add('WaterVolume', {
    size: [8, 1, 2],
    position: [0, -0.5, 0],
    waves: true,
    subdivision: [64, 8],
  });
  const rope = w.add('Rope', {
    points: [
      [3, 0, -0.5],
      [3, 0, 0.5],
    ],
    segments: 4,
    mass: 0.15,
  });
  w.advance(0.5);
  addBody(w, { mass: 300, position: [-3, 0.6, 0], geometry: [box(0.8)] });
  let least = Infinity;
  let most = -Infinity;
  for (let i = 0; i < 30; i++) {
    w.advance(0.1);
    for (const [, y] of places(rope)) {
      least = Math.min(least, y);
      most = Math.max(most, y);
    }
  }
  assert.ok(most > 0.05, `from ${least} m to ${most} m`);
});
