import assert from 'node:assert/strict';
import type { LevelMeasurement, LevelName, World } from '../../physics-core/inside.js';
import { workPerMoment } from '../../physics-core/accuracy/work.js';
import {
  above,
  addBody,
  addFloor,
  addJoint,
  below,
  box,
  claim,
  close,
  fact,
  height,
  sphere,
  world,
  type Body,
} from './helpers.js';

const by = (rows: LevelMeasurement[], level: LevelName): LevelMeasurement =>
  rows.find((row) => row.level === level)!;

/** Poses and velocities of all bodies, to the last bit. */
const bits = (w: World): string =>
  JSON.stringify([...w.bodies].map((body) => [body.pose(), [...w.bodies.velocityOf(body)]]));

/** A ball on a hinge, let go level. */
async function pendulum(fields: Record<string, unknown> = {}): Promise<World> {
  const w = await world(fields);
  const ball = addBody(w, { position: [1, 0, 0], geometry: [sphere(0.1)] });
  addJoint(w, 'SingleAxisHingeJoint', { body1: ball, axis: [0, 0, 1] });
  w.advance(0.3);
  return w;
}

/** Boxes and balls that fall onto a floor and a jointed pair, and are listened to. */
async function busy(): Promise<World> {
  const w = await world({ rest: 'auto' });
  addFloor(w);
  w.add('CollisionCollection', {
    collidables: '*',
    appliedParameters: ['BOUNCE'],
    bounce: 0.4,
  });
  for (let i = 0; i < 12; i++)
    addBody(w, {
      position: [0.3 * (i % 3), 1 + i, 0.2 * (i % 2)],
      geometry: [i % 2 ? sphere(0.4) : box(0.7)],
    }).on('collisionstart', () => {});
  const last = addBody(w, { position: [4, 2, 0] });
  addJoint(w, 'BallJoint', { body1: last, anchorPoint: [3, 2, 0] });
  w.advance(1);
  return w;
}

// ---- errors ----------------------------------------------------------------------------------------------------------

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

fact('the finest of the levels asked for is what the others are compared with', async () => {
  const w = await pendulum();
  const rows = await w.measureAccuracy({ seconds: 0.5, levels: ['fine', 'game'] });
  assert.deepEqual(
    rows.map(({ level, error }) => [level, error.position > 0]),
    [
      ['game', true],
      ['fine', false],
    ],
  );
  const [alone] = await w.measureAccuracy({ seconds: 0.1, levels: ['game'] });
  assert.equal(alone!.error.position, 0);
});

fact('the deepest overlap of a ball at rest is the depth that contacts keep', async () => {
  const w = await world();
  addFloor(w);
  addBody(w, { position: [0, 0.5, 0] });
  w.advance(1);
  for (const { error, contacts } of await w.measureAccuracy({ seconds: 0.5 })) {
    close(error.penetration, 1e-4, 2e-5, 'm');
    above(contacts, 0);
  }
});

fact('what is torn and what cannot hold shows in the joint error', async () => {
  const w = await world({ constantForceMix: 0.01, errorCorrection: 0.2 });
  const ball = addBody(w, { mass: 2 });
  addJoint(w, 'BallJoint', { body1: ball });
  w.advance(1);
  const sag = Math.hypot(...(ball.get('position') as number[]));
  above(sag, 1e-3, 'm');
  const [row] = await w.measureAccuracy({ seconds: 0.5, levels: ['standard'] });
  close(row!.error.joint, sag, 0.01 * sag, 'm');
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

// ---- chaos -----------------------------------------------------------------------------------------------------------

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
    close(tolerance, 0.03, 0.02, 'm, 1 % of the longest way');
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

// ---- the running world -----------------------------------------------------------------------------------------------

fact(
  'the running world notices nothing: bits, counts, problems and events are as without',
  async () => {
    const run = async (measured: boolean) => {
      const w = await busy();
      const events: string[] = [];
      for (const name of ['accuracy', 'problem', 'restore', 'reset', 'lag'])
        w.on(name, () => events.push(name));
      for (const body of w.bodies)
        for (const name of ['sleep', 'wake', 'collisionstart', 'collisionend'])
          body.on(name, () => events.push(`${name} ${body.id}`));
      const before = { bits: bits(w), stats: w.stats, time: w.time, accuracy: w.accuracy };
      if (measured) await w.measureAccuracy({ seconds: 0.2 });
      const after = { bits: bits(w), stats: w.stats, time: w.time, accuracy: w.accuracy };
      assert.deepEqual(after, before);
      w.advance(1.5);
      return { bits: bits(w), events, problems: w.problems.length, stats: w.stats };
    };
    assert.deepEqual(await run(true), await run(false));
  },
);

fact('it may go on running, and be taken down, while it is measured', async () => {
  const [w, alone] = [await busy(), await busy()];
  const measuring = w.measureAccuracy({ seconds: 0.2 });
  for (const each of [w, alone]) each.advance(0.5);
  assert.equal(bits(w), bits(alone));
  const rows = await measuring;
  assert.deepEqual(
    rows.map(({ error }) => error),
    (await (await busy()).measureAccuracy({ seconds: 0.2 })).map(({ error }) => error),
    'from the state it had when it was asked',
  );
});

fact('what is listened to switches the same effects on where it is measured', async () => {
  const w = await busy();
  const copied = structuredClone(w.snapshot());
  const heard = copied.nodes.filter((node) => node.heard.includes('collisionstart'));
  assert.equal(heard.length, 12);
});

fact('contacts that page code once handed over do not act again where it is measured', async () => {
  const w = await world();
  addFloor(w);
  addBody(w, { position: [0, 0.5, 0] });
  w.advance(0.5);
  w.settings.event('set_contacts', []);
  w.step();
  w.advance(0.5);
  const state = w.snapshot().nodes.find(({ type }) => type === 'RigidBodyCollection')!;
  assert.ok(!state.authored.includes('set_contacts'));
  const [row] = await w.measureAccuracy({ seconds: 0.2, levels: ['standard'] });
  below(row!.error.penetration, 2e-4, 'm: nothing sank in');
});

fact('what acts from outside is named', async () => {
  const w = await pendulum();
  const body = [...w.bodies][0]!;
  w.on('beforestep', () => {});
  body.on('collisionend', () => {});
  body.event('linearDampingFactor', 0.1);
  const [row] = await w.measureAccuracy({ seconds: 0.1, levels: ['game'] });
  assert.deepEqual(
    row!.leftOut.map(({ reason }) => reason),
    ['beforestep listeners', 'collisionend listeners', 'later events to linearDampingFactor'],
  );
  assert.equal(row!.leftOut[1]!.element, body);
  assert.equal(row!.inWorker, false);
});

fact('work is the mean of what is usual, whatever else the machine does, by any clock', () => {
  const steady = Array.from({ length: 100 }, (_, i) => 2 + (i % 2));
  close(workPerMoment(steady), 2.5, 1e-9, 'ms');
  const disturbed = steady.map((ms, i) => (i % 10 === 0 ? 80 : ms));
  // Ten of the moments that take 2 ms count as the usual 3.
  close(workPerMoment(disturbed), 2.6, 1e-9, 'ms');
  // A clock that ticks once a millisecond shows 0.2 ms as 0 or 1.
  const ticks = Array.from({ length: 100 }, (_, i) => (i % 5 === 0 ? 1 : 0));
  close(workPerMoment(ticks), 0.2, 0.01, 'ms');
  above(workPerMoment([0, 0, 0]), 0, 'ms');
});

// ---- how it is asked -------------------------------------------------------------------------------------------------

fact('it tells how far it is, and stops when it is told to', async () => {
  const w = await pendulum();
  const shares: number[] = [];
  const stop = new AbortController();
  const { now } = performance;
  let time = 0;
  // A slice ends after 4 ms.
  performance.now = () => (time += 0.01);
  const onprogress = (share: number): void => {
    shares.push(share);
    if (share > 0.3) stop.abort();
  };
  await assert.rejects(
    w.measureAccuracy({ seconds: 1, onprogress, signal: stop.signal }),
    (error: Error) => error.name === 'AbortError',
  );
  performance.now = now;
  above(shares.length, 3);
  assert.deepEqual(
    shares,
    [...shares].sort((a, b) => a - b),
  );
  below(shares.at(-1)!, 0.5);
  await assert.rejects(w.measureAccuracy({ signal: AbortSignal.abort() }));
});

fact('what cannot be measured is reported, and what can is used', async () => {
  const w = await pendulum();
  claim(w, 'bad-value');
  const rows = await w.measureAccuracy({ levels: ['game', 'best'] as never, seconds: 0.1 });
  assert.deepEqual(
    rows.map(({ level }) => level),
    ['game'],
  );
  const [row] = await w.measureAccuracy({ levels: ['game'], seconds: -1 });
  assert.equal(row!.seconds, 2);
});

fact('the body that is farthest off is named', async () => {
  const w = await pendulum();
  const still = addBody(w, { position: [9, 0, 0], useGlobalGravity: false });
  const [row] = await w.measureAccuracy({ seconds: 0.5 });
  assert.notEqual(row!.worst, still);
  assert.ok([...w.bodies].includes(row!.worst as Body));
  below(height(still), 1e-9, 'm');
});
