import assert from 'node:assert/strict';
import { World } from '../../../physics-core/inside.js';
import { addBody, close, fact, world, type Body } from '../helpers.js';

/** Where a body is drawn. */
const drawn = (w: World, body: Body): number[] => [
  ...w.poses.data.slice(body.slot * 7, body.slot * 7 + 3),
];

fact(
  'between two steps a body is drawn between their poses, evenly at a constant speed',
  async () => {
    const w = await world({ gravity: [0, 0, 0] });
    const ball = addBody(w, { linearVelocity: [1.2, 0, 0], angularVelocity: [0, 0, 1.2] });
    w.frame(1 / 480);
    let last: number | undefined;
    for (let i = 0; i < 48; i++) {
      w.frame(1 / 480);
      const [x] = drawn(w, ball);
      const angle = 2 * Math.asin(w.poses.data[ball.slot * 7 + 5]!);
      close(angle, x!, 1e-5, 'rad, turning as it goes');
      if (last !== undefined && i > 3) close(x! - last, 1.2 / 480, 1e-6, 'm per frame');
      last = x;
    }
  },
);

fact('a teleport is drawn at once, not smeared over a frame', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const ball = addBody(w, { linearVelocity: [1, 0, 0] });
  for (let i = 0; i < 5; i++) w.frame(1 / 480);
  ball.set('position', [50, 0, 0]);
  w.frame(1 / 480);
  assert.ok(drawn(w, ball)[0]! >= 50, `drawn at ${drawn(w, ball)[0]}`);
  ball.teleport([-50, 0, 0]);
  w.frame(1 / 480);
  assert.ok(drawn(w, ball)[0]! <= -49.9, `drawn at ${drawn(w, ball)[0]}`);
});

fact('a fixed body that jumps is drawn where it is, however many steps a frame takes', async () => {
  for (const rate of [30, 60, 144]) {
    const w = await world();
    addBody(w, { position: [0, 50, 0] });
    const post = addBody(w, { fixed: true, position: [1, 2, 3] });
    w.frame(1 / rate);
    close(drawn(w, post), [1, 2, 3], 1e-6, `m at ${rate} Hz`);
    post.set('position', [9, 2, 3]);
    w.frame(1 / rate);
    close(drawn(w, post), [9, 2, 3], 1e-6, `m at ${rate} Hz, moved`);
    for (let i = 0; i < 30; i++) w.frame(1 / rate);
    assert.ok(![...w.poses.moved.slice(0, w.poses.movedCount)].includes(post.slot), 'drawn once');
  }
});

fact('what wakes is drawn on its way from where it slept', async () => {
  const w = await world();
  const body = addBody(w, { position: [0, 5, 0] });
  w.step(30);
  body.sleep();
  w.poses.interpolate(1);
  const [, slept] = body.readPose([]);
  body.wake();
  w.step();
  w.poses.interpolate(0);
  close(drawn(w, body)[1]!, slept!, 1e-12, 'm');
});
