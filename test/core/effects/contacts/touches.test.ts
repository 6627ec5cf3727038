import assert from 'node:assert/strict';
import type { World } from '../../../../physics-core/inside.js';
import type { Collision } from '../../../../physics-core/effects/contacts/touches.js';
import {
  addBody,
  addFloor,
  below,
  box,
  close,
  fact,
  isColliding,
  sphere,
  world,
  type Body,
  type Node,
} from '../../helpers.js';

interface Heard {
  event: 'collisionstart' | 'collisionend';
  detail: Collision;
}

/** Everything that a body tells of its collisions. */
function hear(node: Node): Heard[] {
  const heard: Heard[] = [];
  for (const event of ['collisionstart', 'collisionend'] as const)
    node.on(event, (detail) => heard.push({ event, detail: detail as Collision }));
  return heard;
}

const names = (heard: Heard[]): string[] =>
  heard.map(({ event, detail }) => (detail.reason ? `${event} ${detail.reason}` : event));

async function falling(fields: Record<string, unknown> = {}) {
  const w = await world();
  const floor = addFloor(w);
  const ball = addBody(w, { position: [0, 1, 0], ...fields });
  return { w, floor, ball };
}

fact('both bodies hear when they begin to touch: who, where, how hard and when', async () => {
  const { w, floor, ball } = await falling({ mass: 2 });
  const [up, down] = [hear(ball), hear(floor)];
  w.advance(1);
  assert.deepEqual(names(up), ['collisionstart']);
  assert.deepEqual(names(down), ['collisionstart']);
  const [a, b] = [up[0]!.detail, down[0]!.detail];
  assert.deepEqual([a.other, b.other], [floor, ball]);
  // Half a metre's fall takes 0.319 s and ends at 3.13 m/s; the hit takes a step or two.
  close(a.time, Math.sqrt(1 / 9.8), 3 * w.timeStep, 's');
  close(a.impulse, 2 * Math.sqrt(9.8), 0.3, 'N s');
  close(b.impulse, a.impulse, 0, 'N s, the same');
  assert.equal(a.contacts.length, 1);
  close(a.contacts[0]!.position, [0, 0, 0], 0.01, 'm');
  close(a.contacts[0]!.normal, [0, 1, 0], 1e-3, 'into the ball');
  close(b.contacts[0]!.normal, [0, -1, 0], 1e-3, 'into the floor');
});

fact('a bouncing ball tells of each touch once, at its start and at its end', async () => {
  const { w, ball } = await falling();
  w.add('CollisionCollection', { collidables: '*', bounce: 0.7 });
  const heard = hear(ball);
  let touching = 0;
  for (const event of ['collisionstart', 'collisionend'])
    ball.on(event, () => {
      touching += event === 'collisionstart' ? 1 : -1;
      assert.ok(touching === 0 || touching === 1);
    });
  w.advance(2);
  const starts = heard.filter(({ event }) => event === 'collisionstart').length;
  assert.ok(starts > 3, `${starts} starts`);
  below(Math.abs(heard.length - 2 * starts), 2, 'events without a partner');
});

fact('what lies still for 10 s tells nothing more, awake or asleep', async () => {
  for (const rest of ['never', 'auto']) {
    const w = await world({ rest });
    addFloor(w);
    const stones = [0.5, 1.5, 2.5].map((y) =>
      addBody(w, { position: [0, y, 0], geometry: [box(1)] }),
    );
    const ball = addBody(w, { position: [3, 0.5, 0] });
    const heard = [...stones, ball].map(hear);
    w.advance(10);
    assert.deepEqual(
      heard.map((each) => names(each).join()),
      [
        'collisionstart,collisionstart',
        'collisionstart,collisionstart',
        'collisionstart',
        'collisionstart',
      ],
      rest,
    );
    assert.equal(ball.sleeping, rest === 'auto');
    assert.equal(isColliding(ball), true);
  }
});

fact('a touch ends by its reason: parted, removed, disabled, reset', async () => {
  const ends: [string, (ball: Body, w: World) => void][] = [
    ['separated', (ball) => ball.set('linearVelocity', [0, 5, 0])],
    ['removed', (ball) => ball.remove()],
    ['disabled', (ball) => ball.set('enabled', false)],
    ['reset', (_, w) => w.reset()],
  ];
  for (const [reason, end] of ends) {
    const { w, floor, ball } = await falling({ position: [0, 0.51, 0] });
    const heard = hear(floor);
    w.advance(0.5);
    end(ball, w);
    w.step(3);
    assert.deepEqual(names(heard).slice(0, 2), ['collisionstart', `collisionend ${reason}`]);
    assert.equal(heard[1]!.detail.other, ball);
    if (reason !== 'reset') assert.equal(isColliding(ball), false);
  }
});

fact('an edit that makes a body anew, or gives it another shape, ends no touch', async () => {
  const { w, ball } = await falling({ position: [0, 0.5, 0] });
  const heard = hear(ball);
  w.advance(0.2);
  ball.set('mass', 3);
  ball.set('geometry', [sphere(0.5)]);
  w.advance(0.2);
  ball.set('fixed', true);
  w.advance(0.2);
  assert.equal(names(heard)[0], 'collisionstart');
  assert.equal(heard.filter(({ event }) => event === 'collisionstart').length, 1);
});

fact('listeners may remove either body; each start still has one end', async () => {
  const { w, ball } = await falling({ position: [0, 0.51, 0] });
  const heard = hear(ball);
  ball.on('collisionstart', () => ball.remove());
  w.advance(0.5);
  assert.deepEqual(names(heard), ['collisionstart', 'collisionend removed']);
});

fact('nothing is read where nobody listens, and nothing any more when they cease', async () => {
  const { w, ball } = await falling();
  const reading = () => w.effects.find(({ name }) => name === 'contact reading')!.active;
  w.step();
  assert.equal(reading(), false);
  const stop = [ball.on('collisionstart', () => {}), ball.on('collisionend', () => {})];
  assert.equal(reading(), true);
  stop[0]!();
  assert.equal(reading(), true);
  stop[1]!();
  w.step();
  assert.equal(reading(), false);
  ball.on('sleep', () => {});
  assert.equal(reading(), false);
});

fact('two stones that never meet hear nothing', async () => {
  const { w, ball } = await falling();
  const other = addBody(w, { position: [5, 0.5, 0] });
  const heard = hear(other);
  w.advance(1);
  assert.deepEqual(names(heard), ['collisionstart']);
  assert.notEqual(heard[0]!.detail.other, ball);
});

fact(
  'a collidable without a body hears its own collisions, and is named as the other',
  async () => {
    const w = await world();
    const slab = w.add('CollidableShape', { shape: [box(20, 1, 20)], translation: [0, -0.5, 0] });
    const round = w.add('CollidableShape', { shape: [sphere(0.5)] });
    const ball = addBody(w, { position: [0, 0.6, 0], geometry: [round] });
    w.add('CollisionCollection', { collidables: [slab, round] });
    const [of, by] = [hear(slab), hear(ball)];
    w.advance(0.5);
    assert.deepEqual([names(of), names(by)], [['collisionstart'], ['collisionstart']]);
    assert.deepEqual([of[0]!.detail.other, by[0]!.detail.other], [ball, slab]);
  },
);
