import assert from 'node:assert/strict';
import type { World } from '../../../../physics-core/inside.js';
import { addBody, addFloor, addJoint, box, fact, sphere, world } from '../../../core/helpers.js';
import { leavesNoTrace } from '../../../core/no-trace.js';

/** A compound body on a joint, stepped, and taken away in either order. */
function cycle(w: World, anchor: ReturnType<typeof addBody>, i: number): void {
  const body = addBody(w, {
    position: [0, 2, 0],
    geometry: [
      box(1),
      { type: 'CollidableOffset', translation: [1, 0, 0], collidable: sphere(0.4) },
    ],
  });
  const joint = addJoint(w, i % 3 ? 'BallJoint' : 'SingleAxisHingeJoint', {
    body1: anchor,
    body2: body,
    anchorPoint: [0, 3, 0],
  });
  w.step(i % 10 === 0 ? 1 : 0);
  if (i % 2) {
    joint.remove();
    body.remove();
  } else {
    body.remove();
    joint.remove();
  }
}

fact('ten thousand compound bodies with a joint come and go without a trace', async () => {
  const w = await world();
  addFloor(w);
  const anchor = addBody(w, { fixed: true, position: [0, 3, 0] });
  const nodes = [...w.nodes].length;
  await leavesNoTrace(w, () => {
    for (let i = 0; i < 2000; i++) cycle(w, anchor, i);
  });
  assert.deepEqual([w.stats.bodies, w.stats.joints], [2, 0]);
  assert.equal([...w.nodes].length, nodes);
  const { created, destroyed } = w.stats;
  assert.ok(created - destroyed < 10, `${created} made, ${destroyed} unmade`);
});

fact('a thousand bodies added and removed ten times leave the heap at its size (S28)', async () => {
  const w = await world();
  let size = 0;
  for (let i = 0; i < 60; i++) {
    const bodies = Array.from({ length: 1000 }, (_, k) =>
      addBody(w, { position: [2 * (k % 32), 0, 2 * Math.floor(k / 32)] }),
    );
    if (i % 10 === 0) w.step();
    else w.step(0);
    for (const body of bodies) body.remove();
    size ||= w.stats.heapBytes;
  }
  assert.equal(w.stats.heapBytes, size);
  assert.equal(w.stats.bodies, 0);
});
