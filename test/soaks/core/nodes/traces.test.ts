import type { World } from '../../../../physics-core/inside.js';
import { addBody, addFloor, addJoint, box, fact, sphere, world } from '../../../core/helpers.js';
import { leavesNoTrace } from '../../../core/no-trace.js';

fact(
  'a thousand changes of shape, mass, mobility and joint leave no trace in the heap',
  async () => {
    const w = await world();
    addFloor(w);
    const stone = addBody(w, { position: [0, 2, 0], geometry: [box(1)] });
    const joint = addJoint(w, 'SingleAxisHingeJoint', { body1: stone });
    const mesh = {
      type: 'IndexedFaceSet',
      coord: [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1],
      coordIndex: [0, 2, 1, -1, 0, 1, 3, -1, 1, 2, 3, -1, 2, 0, 3, -1],
    };
    const change = (i: number) => {
      stone.set('geometry', [[box(1)], [sphere(0.4), box(2)], [mesh]][i % 3]);
      stone.set('centerOfMass', [0, (i % 5) / 10, 0]);
      stone.set('fixed', i % 2 === 0);
      joint.set('anchorPoint', [i % 7, 0, 0]);
      stone.set('enabled', i % 11 !== 0);
      w.step(i % 4);
    };
    await leavesNoTrace(w, () => {
      for (let i = 0; i < 1155; i++) change(i);
    });
  },
);

fact('resets and whole worlds come and go without a trace in the heap', async () => {
  const w = await world();
  const scene = (to: World) => {
    addFloor(to);
    for (let i = 0; i < 10; i++) addBody(to, { position: [0, 1 + i, 0], geometry: [box(1)] });
    to.add('CollisionCollection', { collidables: '*', bounce: 0.5 });
    to.step(10);
  };
  scene(w);
  const round = async () => {
    w.reset();
    w.step(10);
    const other = await world();
    scene(other);
    other.destroy();
  };
  await leavesNoTrace(w, async () => {
    for (let i = 0; i < 20; i++) await round();
  });
});
