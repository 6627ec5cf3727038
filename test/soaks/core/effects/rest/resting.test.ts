import assert from 'node:assert/strict';
import {
  addBody,
  addFloor,
  addJoint,
  box,
  close,
  fact,
  random,
  world,
} from '../../../../core/helpers.js';

fact('no pose drawn differs by more than a millimetre from the run without rest', async () => {
  const build = async (rest: string) => {
    const w = await world({ rest });
    addFloor(w);
    const next = random(11);
    for (let i = 0; i < 12; i++)
      addBody(w, {
        position: [2.5 * i, 0.6 + 0.2 * next(), 0],
        orientation: [0, 1, 0, next()],
        geometry: [box(1)],
        mass: 1 + next(),
      });
    const bob = addBody(w, { position: [-4, 4, 0], autoDamp: true, linearDampingFactor: 1 });
    addJoint(w, 'BallJoint', { body1: bob, anchorPoint: [-4, 5, 0] });
    return w;
  };
  const [resting, awake] = [await build('auto'), await build('never')];
  let slept = 0;
  for (let i = 0; i < 15 * 60; i++) {
    resting.frame(1 / 60);
    awake.frame(1 / 60);
    slept = Math.max(slept, resting.stats.bodies - 1 - resting.stats.awake);
    for (const body of resting.bodies) {
      const at = body.slot * 7;
      const here = [...resting.poses.data.slice(at, at + 3)];
      const there = [...awake.poses.data.slice(at, at + 3)];
      close(here, there, 1e-3, `m at ${(i / 60).toFixed(2)} s`);
    }
  }
  assert.ok(slept >= 8, `only ${slept} slept`);
});
