import assert from 'node:assert/strict';
import { levels } from '../../../../physics-core/dynamics/levels.js';
import { addBody, addJoint, box, close, fact, height, sphere, world } from '../../helpers.js';
import { addSea, G, IDEAL, swing, tilt } from './helpers.js';

/** Of a period and of an amplitude, as a share: what is asked. */
const EXACT = 1e-3;
/** Of what heaves, at any step: what is left is rounding to single precision. */
const HEAVE = 1e-5;

const AMPLITUDE = 0.02;

/** How a body floats, and the square of the rate at which it heaves, 1/s². */
const HEAVES: Record<string, { mass: number; geometry: unknown; square: number }> = {
  'a box': { mass: 2000, geometry: box(2, 1, 2), square: (1000 * G * 4) / 2000 },
  'a small box': { mass: 0.2, geometry: box(0.1, 0.05, 0.1), square: (1000 * G * 0.01) / 0.2 },
  'a cylinder': {
    mass: 200,
    geometry: { type: 'Cylinder', radius: 0.8, height: 0.3 },
    square: (1000 * G * Math.PI * 0.64) / 200,
  },
};

for (const [name, { mass, geometry, square }] of Object.entries(HEAVES))
  for (const { name: accuracy } of levels)
    fact(`${name} heaves with the period of the closed form, at ${accuracy}`, async () => {
      const w = await world({ accuracy });
      addSea(w, IDEAL);
      const size = name === 'a small box' ? AMPLITUDE / 10 : AMPLITUDE;
      const rest = addBody(w, { mass, geometry: [geometry] });
      const low = heightAtRest(mass, geometry as { size?: number[]; height?: number });
      rest.teleport([0, low + size, 0]);
      const { period, most } = swing(w, 8, () => height(rest) - low);
      close(period / ((2 * Math.PI) / Math.sqrt(square)), 1, HEAVE);
      close(most / size, 1, EXACT);
    });

/** Of what has the same cross-section at every height. */
function heightAtRest(mass: number, geometry: { size?: number[]; height?: number }): number {
  const tall = geometry.size?.[1] ?? geometry.height!;
  const area = geometry.size ? geometry.size[0]! * geometry.size[2]! : Math.PI * 0.64;
  return tall / 2 - mass / 1000 / area;
}

fact(
  'a ball half in water heaves by √(3 g / 2 r), and keeps its amplitude for a minute',
  async () => {
    const w = await world();
    addSea(w, IDEAL);
    const ball = addBody(w, { mass: (1000 * Math.PI) / 12, geometry: [sphere(0.5)] });
    ball.teleport([0, 0.01, 0]);
    const { period, most } = swing(w, 60, () => height(ball));
    close(period / ((2 * Math.PI) / Math.sqrt(3 * G)), 1, EXACT);
    close(most / 0.01, 1, EXACT);
  },
);

for (const { name: accuracy } of levels)
  fact(`a raft rolls by its metacentric height, at ${accuracy}`, async () => {
    const w = await world({ accuracy });
    addSea(w, IDEAL);
    const start = 0.01;
    const raft = addBody(w, {
      mass: 4000,
      orientation: [0, 0, 1, start],
      geometry: [box(4, 1, 2)],
    });
    // Half of it is below: BM = I / V, G is a quarter of its height above B.
    const metacentric = (4 * 4) / 12 / 0.5 - 0.25;
    const square = (G * metacentric) / ((16 + 1) / 12);
    const { period, most } = swing(w, 20, () => tilt(raft));
    close(period / ((2 * Math.PI) / Math.sqrt(square)), 1, EXACT);
    close(most / start, 1, EXACT);
  });

fact(
  'a square beam stays upright where its metacentre is above it, and tips over where not',
  async () => {
    // Of a density s: 6 s (1 - s) < 1, so for s below 0.2113.
    for (const [share, stands] of [
      [0.2, true],
      [0.225, false],
      [0.775, false],
      [0.8, true],
    ] as const) {
      const w = await world();
      addSea(w, { damping: 0.5, dragCoefficient: 0, liftCoefficient: 0 });
      const beam = addBody(w, {
        mass: 6000 * share,
        position: [0, 0.5 - share, 0],
        orientation: [0, 0, 1, 0.01],
        geometry: [box(1, 1, 6)],
      });
      w.advance(60);
      assert.equal(Math.abs(tilt(beam)) < 0.01, stands, `density ${share}: tilt ${tilt(beam)}`);
    }
  },
);

fact('two that a hinge holds together heave as one does, and keep their amplitude', async () => {
  const w = await world();
  addSea(w, IDEAL);
  const [left, right] = [-0.5, 0.5].map((x) =>
    addBody(w, { mass: 500, position: [x, AMPLITUDE, 0], geometry: [box(1, 0.5, 2)] }),
  );
  addJoint(w, 'SingleAxisHingeJoint', {
    body1: left,
    body2: right,
    anchorPoint: [0, AMPLITUDE, 0],
    axis: [0, 0, 1],
  });
  const { period, most } = swing(w, 20, () => height(left!));
  close(period / ((2 * Math.PI) / Math.sqrt((2000 * G) / 500)), 1, EXACT);
  close(most / AMPLITUDE, 1, EXACT);
});

fact('damping takes half of it from the rate at which a swing dies down', async () => {
  const w = await world();
  addSea(w, { ...IDEAL, damping: 0.4 });
  const raft = addBody(w, {
    mass: 2000,
    position: [0, AMPLITUDE, 0],
    geometry: [box(2, 1, 2)],
  });
  const { most } = swing(w, 10, () => height(raft));
  // The last crest of which all is seen lies within the last quarter.
  const period = (2 * Math.PI) / Math.sqrt((1000 * G * 4) / 2000);
  const crest = Math.ceil(7.5 / (period / 2)) * (period / 2);
  close(most / AMPLITUDE, Math.exp(-0.2 * crest), 0.01);
});
