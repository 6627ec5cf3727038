import assert from 'node:assert/strict';
import {
  above,
  addBody,
  addFloor,
  addJoint,
  below,
  claim,
  close,
  fact,
  world,
} from '../helpers.js';
import { authoredIn } from '../../../physics-core/world/snapshot/snapshot.js';
import { statesIn } from '../../../physics-core/world/snapshot/states.js';
import { busy, pendulum } from './scenes.js';

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

fact('what is listened to switches the same effects on where it is measured', async () => {
  const w = await busy();
  const copied = structuredClone(w.snapshot());
  const heard = copied.heard.filter(([, events]) => events.includes('collisionstart'));
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
  const state = statesIn(w.snapshot()).find(({ type }) => type === 'RigidBodyCollection')!;
  assert.ok(!authoredIn(state).includes('set_contacts'));
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
