import { debugLines } from '../../../../physics-core/debug-lines.js';
import { addBody, fact, world } from '../../helpers.js';
import { leavesNoTrace } from '../../no-trace.js';

fact('the debug drawing of a hull gives back what it took', async () => {
  const w = await world();
  const coord = { point: [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1] };
  const tetrahedron = {
    type: 'IndexedTriangleSet',
    index: [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3],
    coord,
  };
  addBody(w, { geometry: [tetrahedron] });
  w.step(0);
  await leavesNoTrace(w, async () => {
    for (let i = 0; i < 100; i++) {
      const lines = await debugLines(w);
      lines.update();
      lines.dispose();
    }
  });
});
