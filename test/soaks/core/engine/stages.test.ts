import assert from 'node:assert/strict';
import type { World } from '../../../../physics-core/inside.js';
import {
  addBody,
  addFloor,
  addJoint,
  box,
  fact,
  position,
  random,
  world,
} from '../../../core/helpers.js';

/** Boxes that fall in a heap, some of them off their centre, a chain, a lift, and a ball that is fast. */
function fill(w: World): () => void {
  addFloor(w);
  const next = random(5);
  for (let i = 0; i < 12; i++)
    addBody(w, {
      position: [next(), 1 + i, next()],
      orientation: [next(), 1, 0, 3 * next()],
      angularVelocity: [next(), next(), next()],
      centerOfMass: i % 3 === 0 ? [0.1, 0, 0] : [0, 0, 0],
      geometry: [box(0.7, 0.5, 0.9)],
    });
  const links = [0, 1, 2].map((i) => addBody(w, { position: [6 + i, 5, 0], mass: 1 + i }));
  links.forEach((body1, i) =>
    addJoint(w, 'BallJoint', {
      body1,
      ...(i > 0 && { body2: links[i - 1] }),
      anchorPoint: [5.5 + i, 5, 0],
    }),
  );
  addBody(w, { position: [-20, 1, 0], linearVelocity: [150, 0, 0] });
  const lift = addBody(w, { fixed: true, position: [12, 0, 0], geometry: [box(2, 0.5, 2)] });
  addBody(w, { position: [12, 1.2, 0] });
  return () => lift.set('position', [12, position(lift)[1] + 0.01, 0]);
}

fact('stage by stage a step moves everything as Bullet’s own does, to the last bit', async () => {
  const worlds = [await world({ rest: 'auto' }), await world({ rest: 'auto' })];
  const [ours, theirs] = worlds.map((w) => {
    const move = fill(w);
    const { engine, bullet } = w;
    if (w === worlds[1]) engine.stages.detach(engine.ammo.getPointer(bullet.bullet));
    const states = [];
    for (let second = 0; second < 6; second++) {
      for (let i = 0; i < 60; i++) {
        move();
        w.step(2);
      }
      states.push(w.snapshot());
    }
    return states;
  });
  assert.deepEqual(ours, theirs);
});
