import { World } from '../../../physics-core/inside.js';
import { addBody, addFloor, addJoint, box, fact, watch, world } from '../../core/helpers.js';
import { leavesNoTrace } from '../../core/no-trace.js';
import { goAwayAtOnce } from '../../core/thread/at-once.js';

/** Of 11 rounds. */
const WORLDS = 61;

fact('hundreds of worlds that begin and end on the other side leave nothing behind', async () => {
  const first = await world();
  await leavesNoTrace(first, () => {
    for (let i = 0; i < WORLDS; i++) {
      const w = watch(new World());
      w.add('RigidBodyCollection', { rest: 'never' });
      w.start(first.engine);
      addFloor(w);
      const bob = addBody(w, { position: [0, 0.5, 0], geometry: [box(1)] });
      addJoint(w, 'BallJoint', { body1: bob, anchorPoint: [0, 1, 0] });
      goAwayAtOnce(w);
      w.step(2);
      if (i % 9 === 0) w.reset();
      w.destroy();
    }
  });
});
