import assert from 'node:assert/strict';
import { box, claim, fact, sphere, world } from '../../helpers.js';

fact(
  'a problem stands while its cause does: new geometry and an equal value take nothing back',
  async () => {
    const w = await world();
    claim(w, 'out-of-range', 'zero-mass', 'bad-value');
    const host = { tag: 'an element' };
    const options = { host };
    const ball = w.add('RigidBody', { mass: -3, geometry: sphere(1) }, options);
    // Of the body's element, as in a page.
    const shape = w.add('CollidableShape', { shape: { type: 'Box', size: [1, 2] } }, options);
    const codes = (): string[] => w.problemsOf(host).map(({ code }) => code).sort(); // prettier-ignore
    assert.deepEqual(codes(), ['bad-value', 'out-of-range']);
    shape.remove();
    assert.deepEqual(codes(), ['out-of-range'], 'its own goes with it');
    ball.set('geometry', box(1));
    w.step();
    assert.deepEqual(codes(), ['out-of-range']);
    ball.set('mass', 0);
    w.step(0);
    ball.set('mass', 0);
    assert.deepEqual(codes(), ['zero-mass'], 'fixed as before');
    ball.set('mass', 'x');
    ball.set('mass', 0);
    assert.ok(!codes().includes('bad-value'));
    ball.set('mass', 2);
    w.step(0);
    assert.deepEqual(codes(), []);
  },
);
