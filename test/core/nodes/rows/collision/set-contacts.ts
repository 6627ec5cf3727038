import assert from 'node:assert/strict';
import { addBody, box, claim, close, height, position, velocity, world } from '../../../helpers.js';
import { scripted } from './contacts.js';
import type { Row } from '../row.js';

/** Of RigidBodyCollection. */
export const setContactsRows: Row[] = [
  {
    field: 'set_contacts',
    effect: 'given contacts',
    fact: 'what a list leaves out does not push; what page code made does, for one step each',
    run: async () => {
      const scene = await scripted();
      const { w, stone } = scene;
      scene.edit((contacts) => contacts);
      w.advance(0.5);
      close(height(stone), 0.5, 1e-3, 'm, handed through');
      scene.edit(() => []);
      const v = velocity(stone)[1];
      w.advance(0.25);
      close(velocity(stone)[1] - v, -9.8 * 0.25, 1e-3, 'm/s, left out');
      scene.edit(undefined);
      stone.event('position', [0, 5, 0]);
      stone.event('linearVelocity', [0, 0, 0]);
      const stop = w.on('beforestep', () => {
        const at = (x: number, z: number) => ({
          type: 'Contact',
          body1: stone,
          position: [x, 4.5, z],
        });
        w.settings.event('set_contacts', [at(1, 1), at(1, -1), at(-1, 1), at(-1, -1)]);
      });
      w.advance(0.5);
      close(position(stone), [0, 5, 0], 1e-3, 'm, on contacts of page code');
      stop();
      w.advance(0.25);
      close(velocity(stone)[1], -9.8 * 0.25, 1e-3, 'm/s, without them');
    },
  },
  {
    field: 'collisionRules',
    effect: 'contact surface',
    fact: 'by the strict rules, without a collider, what a sensor reports acts only where it is handed on',
    run: async () => {
      const scene = await scripted();
      const { w, stone, sensor, collection } = scene;
      const again = (): void => {
        stone.event('position', [0, 0.5, 0]);
        stone.event('linearVelocity', [0, 0, 0]);
      };
      const falls = (what: string): void => {
        again();
        w.advance(0.25);
        close(velocity(stone)[1], -9.8 * 0.25, 1e-3, `m/s, ${what}`);
      };
      w.set('collisionRules', 'strict');
      falls('not handed on');
      assert.equal(sensor.get('isActive'), true);
      again();
      scene.edit((contacts) => contacts);
      w.advance(1);
      close(height(stone), 0.5, 2e-3, 'm, handed on');
      close(velocity(stone), [0, 0, 0], 1e-3, 'm/s, handed on');
      scene.edit(undefined);
      falls('no longer handed on');
      // Nothing is found where nobody watches.
      again();
      sensor.set('enabled', false);
      w.advance(0.1);
      assert.equal(w.bullet.contactCount, 0);
      again();
      sensor.set('enabled', true);
      w.step(2);
      assert.ok(w.bullet.contactCount > 0);
      collection.set('enabled', false);
      again();
      w.advance(0.1);
      assert.equal(w.bullet.contactCount, 0);
      collection.set('enabled', true);
      // With a collider contacts act by themselves.
      w.set('collider', collection);
      again();
      w.advance(0.5);
      close(height(stone), 0.5, 1e-3, 'm, with a collider');
    },
  },
  {
    field: 'maxCorrectionSpeed',
    effect: 'contact surface',
    fact: 'overlaps are pushed apart no faster than this and gain no velocity; -1 sets no limit',
    run: async () => {
      const w = await world({ gravity: [0, 0, 0] });
      claim(w, 'initial-overlap');
      addBody(w, { fixed: true, position: [0, -0.5, 0], geometry: [box(20, 1, 20)] });
      const stone = addBody(w, { position: [0, 0.3, 0], geometry: [box(2, 1, 2)] });
      w.set('maxCorrectionSpeed', 0.1);
      w.advance(0.5);
      close(height(stone), 0.35, 2e-3, 'm at 0.1 m/s');
      w.set('maxCorrectionSpeed', 0.2);
      w.advance(0.25);
      close(height(stone), 0.4, 2e-3, 'm at 0.2 m/s');
      close(velocity(stone), [0, 0, 0], 1e-3, 'm/s');
      w.set('maxCorrectionSpeed', 0);
      w.advance(0.5);
      close(height(stone), 0.4, 2e-3, 'm at 0');
      w.settings.unset('maxCorrectionSpeed');
      w.advance(0.1);
      close(height(stone), 0.5, 5e-3, 'm, no limit');
    },
  },
];
