import assert from 'node:assert/strict';
import { describe } from 'node:test';
import { bulletHas, touchedBy } from '../../../physics-core/inside.js';
import { addBody, addFloor, addJoint, box, claim, close, fact, sphere, world } from '../helpers.js';

describe('what Bullet has', () => {
  fact('of a body: shapes, mass, moments, motion, joints', async () => {
    const w = await world();
    const body = addBody(w, {
      mass: 3,
      position: [1, 2, 3],
      linearVelocity: [4, 0, 0],
      useGlobalGravity: false,
      geometry: [box(1, 2, 3), { ...sphere(0.25), translation: [0, 0, 2] }],
    });
    const joint = addJoint(w, 'BallJoint', { body1: body, anchorPoint: [1, 2, 3] });
    w.step(0);
    const has = bulletHas(body)!;
    assert.equal(has.state, 'awake');
    assert.deepEqual(
      (has.shapes as { type: string }[]).map(({ type }) => type),
      ['box', 'sphere'],
    );
    assert.equal(has.mass, 3);
    close(has.linearVelocity as number[], [4, 0, 0], 1e-6);
    assert.deepEqual(has.gravity, [0, 0, 0]);
    assert.deepEqual(has.joints, [joint.label]);
    body.sleep();
    assert.equal(bulletHas(body)!.state, 'asleep');
    body.set('fixed', true);
    w.step(0);
    assert.deepEqual([bulletHas(body)!.state, bulletHas(body)!.mass], ['fixed', 0]);
    body.set('enabled', false);
    w.step(0);
    assert.equal(bulletHas(body)!.state, 'taken out: not enabled');
  });

  fact('of a hollow moving mesh: its hull', async () => {
    const w = await world();
    claim(w, 'concave-dynamic');
    const corner = {
      type: 'IndexedTriangleSet',
      index: [0, 1, 2, 0, 2, 3, 0, 3, 1],
      coord: { point: [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1] },
    };
    const body = addBody(w, { fixed: true, geometry: [corner] });
    w.step(0);
    assert.equal((bulletHas(body)!.shapes as { type: string }[])[0]!.type, 'mesh');
    body.set('fixed', false);
    w.step(0);
    assert.equal((bulletHas(body)!.shapes as { type: string }[])[0]!.type, 'hull');
  });

  fact('of a joint: where it is, and what each of its rows holds', async () => {
    const w = await world();
    const arm = addBody(w, { position: [1, 0, 0] });
    const hinge = addJoint(w, 'SingleAxisHingeJoint', {
      body1: arm,
      anchorPoint: [0, 0, 0],
      axis: [0, 0, 1],
      minAngle: -0.5,
      maxAngle: 1,
    });
    w.step(0);
    const { anchor, gap, rows } = bulletHas(hinge)!;
    close(anchor as number[], [0, 0, 0], 1e-6);
    close(gap as number, 0, 1e-6);
    const about = (rows as { row: string; holds: unknown }[]).find((r) => r.row === 'about x')!;
    assert.deepEqual(about.holds, [-0.5, 1]);
    arm.remove();
    w.step(0);
    assert.equal(bulletHas(hinge), undefined);
  });

  fact('of a world: its level and its solver', async () => {
    const w = await world({ accuracy: 'fine' });
    const { level, timeStep, iterations } = bulletHas(w.settings)!;
    assert.deepEqual([level, timeStep, iterations], ['fine', 1 / 240, 20]);
  });

  fact('touched is what lies against it, without anybody listening', async () => {
    const w = await world();
    const floor = addFloor(w);
    const stone = addBody(w, { position: [0, 0.5, 0], geometry: [box(1)] });
    const bird = addBody(w, { position: [0, 50, 0] });
    w.advance(0.25);
    assert.deepEqual(touchedBy(stone), [floor]);
    assert.deepEqual(touchedBy(floor), [stone]);
    assert.deepEqual(touchedBy(bird), []);
    assert.equal(touchedBy(w.settings), undefined);
  });
});
