import { levelNames } from '../../../../physics-core/dynamics/levels.js';
import { addBody, addJoint, below, box, fact, velocity, world, type Body } from '../../helpers.js';
import type { World } from '../../../../physics-core/inside.js';

/** Two rods that hang on each other and on the world. */
async function chain(accuracy: string): Promise<{ w: World; rods: [Body, Body] }> {
  const w = await world({ accuracy });
  const rod = (y: number) => addBody(w, { position: [0, y, 0], geometry: [box(0.2, 0.8, 0.2)] });
  const rods: [Body, Body] = [rod(-1), rod(-2)];
  addJoint(w, 'BallJoint', { body1: rods[0], anchorPoint: [0, -0.5, 0] });
  addJoint(w, 'BallJoint', { body1: rods[0], body2: rods[1], anchorPoint: [0, -1.5, 0] });
  return { w, rods };
}

/** The fastest that any of them is in `seconds`, m/s. */
function fastest(w: World, bodies: Body[], seconds: number): number {
  let most = 0;
  for (let i = 0; i < seconds / w.timeStep; i++) {
    w.step();
    for (const body of bodies) most = Math.max(most, Math.hypot(...velocity(body)));
  }
  return most;
}

for (const accuracy of levelNames)
  fact(
    `at ${accuracy} a link put elsewhere swings as fast as its fall makes it, no faster`,
    async () => {
      const { w, rods } = await chain(accuracy);
      w.advance(0.5);
      rods[1].set('position', [-1, 5, 2]);
      // From at most 2 m above to 2 m below where they hang: √(2 · 9.8 · 4). It was 18 m/s to 285 m/s, each level twice as fast.
      below(fastest(w, rods, 1), 8.9, 'm/s');
    },
  );

for (const accuracy of levelNames)
  fact(`at ${accuracy} what joints torn far apart draw together is not thrown by it`, async () => {
    const w = await world({ accuracy });
    const bodies = [0, 1, 2].map((x) => addBody(w, { position: [x, 0, 0], geometry: [box(0.3)] }));
    const [a, b, c] = bodies as [Body, Body, Body];
    addJoint(w, 'BallJoint', { body1: a, anchorPoint: [-0.5, 0, 0] });
    addJoint(w, 'SliderJoint', { body1: b, body2: a, axis: [0, 1, 0] });
    addJoint(w, 'BallJoint', { body1: c, body2: b, anchorPoint: [1.5, 0, 0] });
    w.advance(0.1);
    for (const [which, ...place] of EDITS) {
      bodies[which]!.set('position', place);
      // Measured 3.5 at most, as fast as they fall; it was 1500, then 20 and a problem.
      below(fastest(w, bodies, 0.05), 4, 'm/s');
    }
  });

/** A body's number, and where it is put. */
const EDITS = [
  [0, -3, -2, -2],
  [0, -4, 1, 1],
  [2, 4, 4, 0],
  [0, -1, 3, 4],
  [2, -1, 2, -1],
] as const;

for (const accuracy of levelNames)
  fact(
    `at ${accuracy} a link thrown into a floor far from its joint is not thrown by that`,
    async () => {
      const w = await world({ accuracy });
      addBody(w, { fixed: true, position: [0, -3, 0], geometry: [box(30, 1, 30)] });
      const link = addBody(w, { position: [0, 0, 0.8], geometry: [box(2, 2, 1)] });
      addJoint(w, 'BallJoint', { body1: link });
      w.advance(0.05);
      // 2.3 m from the joint, and 10 cm deep in the floor; the joint has it back at once.
      link.teleport([0, -1.6, -1.7], undefined, {
        linearVelocity: [-5, -5, 0],
        angularVelocity: [-1, 0, 0],
      });
      // It has 7.07 m/s, and falls for a step.
      below(fastest(w, [link], 2 * w.timeStep), 7.4, 'm/s');
    },
  );
