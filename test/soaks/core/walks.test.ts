import assert from 'node:assert/strict';
import { allEffects } from '../../../physics-core/effects/all.js';
import { Effect } from '../../../physics-core/effects/effect/effect.js';
import { instrumentedCore } from '../../../tools/test/walks/core.js';
import { walked, walks, type Walk } from '../../../tools/test/walks/scenes.js';
import {
  before,
  crossings,
  describe,
  doneTwice,
  named,
  roomOf,
} from '../../../tools/test/walks/walk.js';
import type { Call } from '../../../tools/test/walks/recorder.js';
import { fact, world } from '../../core/helpers.js';

// How far an edit, a step and a question walk through the core, counted while they run (node --import tsx tools/test/walks.ts shows all of it).

let core: ReturnType<typeof instrumentedCore> | undefined;

/** The calls of every function of the core, and of Bullet's, that a walk makes. */
const callsOf = async (walk: Walk): Promise<Call[]> =>
  walked(await (core ??= instrumentedCore()), walk);

/** How often functions of this name are called. */
const times = (calls: Call[], name: string | RegExp): number => named(calls, name).length;

/** What changes something for a second time: on the same object, with the same arguments. */
const repeated = (calls: Call[]): string[] =>
  doneTwice(calls)
    .filter((call) => ['nodes', 'effects', 'engine', 'Bullet'].includes(roomOf(call)))
    .map(describe);

/** Those that are not on the way of another: where a load changes, what hangs together gets the velocities of that moment. */
const besides = (calls: Call[], name: string): Call[] => {
  const within = new Set(named(calls, name));
  for (const call of calls) if (call.caller && within.has(call.caller)) within.add(call);
  return calls.filter((call) => !within.has(call));
};

// A crossing is a call - of a function, method, accessor, constructor or callback - from one room (first folder below
// physics-core) into another. `fields` and `base` are what all rooms speak and reckon with: a call into them crosses
// nothing, and one that they make, as EventQueue.during does, is their caller's.
fact('a new mass is with Bullet after at most eight crossings between rooms', async () => {
  for (const walk of [walks.massOfFree, walks.massOfHinged]) {
    const calls = besides(await callsOf(walk), 'JointSolve.loadChanges');
    const way = crossings(before(calls, 'btRigidBody.setMassProps'));
    const shown = way.map((call) => `${describe(call.caller!)} → ${describe(call)}`);
    assert.ok(way.length > 0 && way.length <= 8, shown.join('\n'));
  }
});

fact('a new mass is told once to Bullet and to each effect that it concerns', async () => {
  for (const walk of [walks.massOfFree, walks.massOfHinged]) {
    const calls = besides(await callsOf(walk), 'JointSolve.loadChanges');
    assert.deepEqual(repeated(calls), []);
    const once = ['setMassProps', 'setGravity', 'setDamping', 'updateInertiaTensor'];
    for (const name of once) assert.equal(times(calls, `btRigidBody.${name}`), 1, name);
    assert.equal(times(calls, 'Flight.need'), 1, 'Flight.need');
    assert.equal(times(calls, 'Effects.bodyChanged'), 1, 'Effects.bodyChanged');
  }
});

fact('of a new mass on a hinge the joint solve is told once', async () => {
  const calls = await callsOf(walks.massOfHinged);
  assert.equal(times(calls, 'JointSolve.need'), 1);
  assert.equal(times(calls, 'JointConstraint.setCorrection'), 6);
  assert.equal(times(calls, 'JointConstraint.setLimits'), 0);
});

fact('a hinge is made once', async () => {
  const calls = await callsOf(walks.hinge);
  assert.equal(times(calls, 'new JointConstraint'), 1);
  assert.equal(times(calls, 'JointConstraint.setLimits'), 1);
  assert.equal(times(calls, 'JointConstraint.setCorrection'), 6);
  assert.equal(times(calls, 'JointSolve.need'), 1);
  assert.deepEqual(repeated(calls), []);
});

fact('for all hinges of a batch the joint solve takes stock once', async () => {
  const calls = await callsOf(walks.hinges);
  assert.equal(times(calls, 'new JointConstraint'), 2);
  assert.equal(times(calls, 'JointSolve.need'), 2);
  assert.equal(times(calls, 'Forest.build'), 1);
});

fact('a body that is made is shown to each effect once', async () => {
  const calls = await callsOf(walks.body);
  assert.equal(times(calls, 'Flight.need'), 1);
  assert.equal(times(calls, /^Effects\.body/), 1);
});

fact('who reads the angle of a hinge has one row looked at, and no M⁻¹Jᵀ', async () => {
  const calls = await callsOf(walks.angle);
  assert.equal(times(calls, 'JointGeometry.value'), 1);
  assert.equal(times(calls, /fill|respond|inverseinertia|between|writeLinear|writeAngular/i), 0);
});

fact('a step of two free bodies makes no effect but free flight, and calls no other', async () => {
  const made = named(await callsOf(walks.begin), 'load');
  assert.deepEqual([...new Set(made.map(({ file }) => file))], ['effects/flight/flight.ts']);
  const ofEffects = (await callsOf(walks.step)).filter((call) => roomOf(call) === 'effects');
  assert.deepEqual([...new Set(ofEffects.map(({ file }) => file))].sort(), [
    'effects/effect/effects.ts',
    'effects/flight/flight.ts',
  ]);
});

// ---- effects that were made before, and are off ----------------------------------------------------------------------

/** Counts the calls of every method and accessor of the classes of these effects. Returns how to stop. */
function countCalls(effects: readonly Effect[], called: (effect: unknown, name: string) => void) {
  const undo: (() => void)[] = [];
  const prototypes = new Set(effects.map((effect) => Object.getPrototypeOf(effect) as object));
  for (const prototype of [...prototypes, Effect.prototype])
    for (const [name, own] of Object.entries(Object.getOwnPropertyDescriptors(prototype))) {
      if (name === 'constructor') continue;
      const counted = { ...own };
      for (const key of ['value', 'get', 'set'] as const) {
        const uncounted = own[key] as unknown;
        if (typeof uncounted !== 'function') continue;
        counted[key] = function (this: unknown, ...values: unknown[]) {
          called(this, name);
          return uncounted.apply(this, values) as unknown;
        };
      }
      Object.defineProperty(prototype, name, counted);
      undo.push(() => Object.defineProperty(prototype, name, own));
    }
  return () => undo.forEach((one) => one());
}

fact('an effect that is off is not called in a step, though it was made', async () => {
  const made = await world();
  for (const y of [0, 5])
    made.add('RigidBody', { position: [0, y, 0], geometry: [{ type: 'Box' }] });
  const all = allEffects.map((each) => made.registry.get(each));
  made.step(3);
  const on = allEffects.filter((each) => made.registry.active(each)).map(({ name }) => name);
  assert.deepEqual(on, ['free flight']);
  const calls = new Map<string, number>();
  const stop = countCalls(all, (effect, name) => {
    const key = allEffects[all.indexOf(effect as Effect)]!.name;
    calls.set(key, (calls.get(key) ?? 0) + 1);
    assert.equal(key, 'free flight', name);
  });
  try {
    made.step();
  } finally {
    stop();
  }
  assert.deepEqual([...calls.keys()], ['free flight']);
});
