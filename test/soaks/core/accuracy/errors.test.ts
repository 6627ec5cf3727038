import assert from 'node:assert/strict';
import type { LevelMeasurement, LevelName } from '../../../../physics-core/inside.js';
import {
  above,
  addBody,
  addFloor,
  addJoint,
  below,
  box,
  close,
  fact,
  height,
  world,
  type Body,
} from '../../../core/helpers.js';
import { pendulum } from '../../../core/accuracy/scenes.js';

const by = (rows: LevelMeasurement[], level: LevelName): LevelMeasurement =>
  rows.find((row) => row.level === level)!;

fact('errors of a pendulum fall with the square of the step, as the method promises', async () => {
  const w = await pendulum();
  const rows = await w.measureAccuracy({ seconds: 1 });
  assert.deepEqual(
    rows.map(({ level }) => level),
    ['game', 'standard', 'fine', 'precise', 'reference'],
  );
  // Against 1/960 s, an error of c·dt² shows as c·(dt² - 1/960²).
  const square = (level: LevelName): number => by(rows, level).timeStep ** 2 - (1 / 960) ** 2;
  for (const [coarse, fine] of [
    ['game', 'standard'],
    ['standard', 'fine'],
  ] as const) {
    const ratio = by(rows, coarse).error.position / by(rows, fine).error.position;
    close(ratio / (square(coarse) / square(fine)), 1, 0.05, `${coarse} over ${fine}`);
  }
  below(by(rows, 'game').error.position, 3e-3, 'm');
  const energies = rows.map(({ error }) => error.energy);
  assert.deepEqual(
    energies,
    [...energies].sort((a, b) => b - a),
    'energy, coarse to fine',
  );
  for (const { error, chaotic, horizon, seconds } of rows) {
    below(error.joint, 1e-5, 'm, widest gap');
    assert.equal(error.penetration, 0);
    assert.equal(chaotic, false);
    assert.equal(horizon, seconds);
  }
});

fact(
  'a motor that does work is no error: its energy is compared with what it should be',
  async () => {
    const w = await world({ gravity: [0, 0, 0] });
    const wheel = addBody(w, { torques: [[0, 0, 1]] });
    addJoint(w, 'SingleAxisHingeJoint', { body1: wheel, axis: [0, 0, 1] });
    w.advance(0.5);
    for (const { level, error } of await w.measureAccuracy({ seconds: 2 }))
      below(error.energy, 1e-3, `at ${level}`);
  },
);

fact('a scene whose roundings grow is called chaotic, and errors end at its horizon', async () => {
  const w = await world();
  addFloor(w);
  for (let i = 0; i < 8; i++)
    addBody(w, {
      position: [(i % 3) * 0.3, 1 + 1.1 * i, (i % 2) * 0.2],
      orientation: [1, i, 0, 0.3 * i],
      geometry: [box(0.8)],
    });
  const rows = await w.measureAccuracy({ seconds: 1.5 });
  for (const { chaotic, horizon, error, tolerance } of rows) {
    assert.equal(chaotic, true);
    above(horizon, 0.3, 's: nothing has met anything yet');
    below(horizon, 1.2, 's');
    above(tolerance, 0.01, 'm, 1 % of the longest way');
    below(tolerance, 0.083, 'm, 1 % of the way from the highest place to the floor');
    below(error.position, 0.2, 'm, where without a horizon boxes would be metres apart');
  }
  above(by(rows, 'game').error.position, 0, 'm');
});

fact('a single ball that bounces is not chaotic, however badly a level bounces it', async () => {
  const w = await world();
  addFloor(w);
  w.add('CollisionCollection', { collidables: '*', appliedParameters: ['BOUNCE'], bounce: 0.8 });
  addBody(w, { position: [0, 3, 0] });
  for (const { chaotic } of await w.measureAccuracy({ seconds: 1.5 })) assert.equal(chaotic, false);
});

fact('the body that is farthest off is named', async () => {
  const w = await pendulum();
  const still = addBody(w, { position: [9, 0, 0], useGlobalGravity: false });
  const [row] = await w.measureAccuracy({ seconds: 0.5 });
  assert.notEqual(row!.worst, still);
  assert.ok([...w.bodies].includes(row!.worst as Body));
  below(height(still), 1e-9, 'm');
});
