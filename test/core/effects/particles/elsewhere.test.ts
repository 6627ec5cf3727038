import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Simulation } from '../../../../physics-core/dynamics/simulation.js';
import type { Bounces } from '../../../../physics-core/effects/particles/bounces.js';
import { hear, Told } from '../../../../physics-core/effects/particles/elsewhere.js';
import { ParticleSystem } from '../../../../physics-core/effects/particles/particle-system.js';
import { PLAIN } from './settings.js';

const make = (): ParticleSystem => new ParticleSystem({} as Simulation, {} as Bounces, () => PLAIN);

/** A second of two systems, as told, and those that heard of it. */
function told() {
  const teller = new Told();
  const there = new Map([3, 8].map((id) => [id, make()]));
  const here = new Map([3, 8].map((id) => [id, make()]));
  const step = (id: number): void => there.get(id)!.step(1 / 60);
  const tell = (room = new Float64Array(1)) => {
    const numbers = teller.write(there, room);
    hear(here, numbers);
    return numbers;
  };
  return { there, here, step, tell };
}

test('what one side has, the other shows: places, births and time', () => {
  const { there, here, step, tell } = told();
  for (let i = 0; i < 60; i++) step(3);
  step(8);
  tell();
  for (const id of [3, 8]) {
    assert.deepEqual(here.get(id)!.picture, there.get(id)!.picture);
    assert.deepEqual(here.get(id)!.progress, there.get(id)!.progress);
  }
});

test('what has not changed is not told again', () => {
  const { step, tell } = told();
  step(3);
  step(8);
  assert.equal(tell()[0], 2);
  step(8);
  assert.equal(tell()[0], 1);
  assert.equal(tell()[0], 0);
});

test('room that is large enough is used again', () => {
  const { step, tell } = told();
  const room = new Float64Array(1000);
  step(3);
  assert.equal(tell(room), room);
});

test('a system that was removed here meanwhile is passed over', () => {
  const { here, there, step, tell } = told();
  here.delete(3);
  step(3);
  step(8);
  tell();
  assert.deepEqual(here.get(8)!.picture, there.get(8)!.picture);
});
