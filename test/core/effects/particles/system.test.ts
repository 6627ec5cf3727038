import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Simulation } from '../../../../physics-core/dynamics/simulation.js';
import type { Bounces } from '../../../../physics-core/effects/particles/bounces.js';
import { PARTICLE } from '../../../../physics-core/effects/particles/cloud.js';
import type { Emitter } from '../../../../physics-core/effects/particles/emit/emitter.js';
import { ParticleSystem } from '../../../../physics-core/effects/particles/particle-system.js';
import type { Settings } from '../../../../physics-core/effects/particles/settings.js';
import { close } from '../../helpers.js';
import { PLAIN } from './settings.js';

/** The same place, and any speed. */
const various: Emitter = {
  emit(draws, birth) {
    birth.set([0, 0, 0, draws.either(), draws.either(), draws.either()]);
    return true;
  },
};

/** A system, and what changes what its author says. */
function systemOf(settings: Partial<Settings>) {
  let said = { ...PLAIN, ...settings };
  const system = new ParticleSystem({} as Simulation, {} as Bounces, () => said);
  const say = (more: Partial<Settings>): void => {
    said = { ...said, ...more };
    system.stale = true;
  };
  return { system, say };
}

function run(system: ParticleSystem, seconds: number, dt = 1 / 60): void {
  for (let i = 0, steps = Math.round(seconds / dt); i < steps; i++) system.step(dt);
}

const motionOf = ({ cloud }: ParticleSystem): number[] => [
  ...cloud.motion.subarray(0, cloud.count * PARTICLE),
];

const STEPS = [1 / 60, 1 / 120, 1 / 960];

for (const dt of STEPS) {
  test(`a thrown particle is where the parabola is, with steps of 1/${Math.round(1 / dt)} s`, () => {
    const { system } = systemOf({ most: 1, lifetime: 10, mass: 2, force: [0, -19.6, 1] });
    run(system, 2, dt);
    const [x, y, z, vx, vy, vz] = motionOf(system) as [
      number,
      number,
      number,
      number,
      number,
      number,
    ];
    for (const [found, right] of [
      [x, 1 + 3 * 2],
      [y, 2 + 4 * 2 - 9.8 * 2],
      [z, 3 + 5 * 2 + 0.5 * 2],
      [vx, 3],
      [vy, 4 - 9.8 * 2],
      [vz, 5 + 0.5 * 2],
    ] as const)
      close(found, right, 1e-10);
  });

  test(`drag slows as Stokes has it, with steps of 1/${Math.round(1 / dt)} s`, () => {
    const k = 1.7;
    const { system } = systemOf({ most: 1, lifetime: 10, damping: k, force: [0, -9.8, 0] });
    run(system, 2, dt);
    const left = Math.exp(-k * 2);
    const [x, y] = motionOf(system) as [number, number];
    close(x, 1 + (3 * (1 - left)) / k, 1e-10);
    const terminal = -9.8 / k;
    close(y, 2 + terminal * 2 + ((4 - terminal) * (1 - left)) / k, 1e-10);
  });
}

test('next to no drag is as none, and any drag leaves finite numbers', () => {
  const where = (damping: number): number[] => {
    const { system } = systemOf({ most: 1, lifetime: 10, damping, force: [0, -9.8, 0] });
    run(system, 2);
    return motionOf(system);
  };
  const free = where(0);
  for (const damping of [1e-12, 1e-9]) where(damping).forEach((x, i) => close(x, free[i]!, 1e-7));
  for (const damping of [1e3, 1e9, 1e300])
    for (const x of where(damping)) assert.ok(Number.isFinite(x), `${x} with ${damping}`);
});

test('drag of any strength is continuous where the series ends', () => {
  const where = (damping: number): number => {
    const { system } = systemOf({ most: 1, lifetime: 10, damping, force: [0, -9.8, 0] });
    system.step(1);
    return motionOf(system)[1]!;
  };
  close(where(0.1 - 1e-12), where(0.1 + 1e-12), 1e-10);
});

test('no force moves what has no mass', () => {
  const wind = { direction: [1, 0, 0], speed: 10, gustiness: 0, turbulence: 0 } as const;
  const { system } = systemOf({
    most: 1,
    mass: 0,
    surfaceArea: 1,
    force: [0, -9.8, 0],
    winds: [{ ...wind, direction: [...wind.direction] }],
  });
  run(system, 1);
  motionOf(system).forEach((x, i) => close(x, [4, 6, 8, 3, 4, 5][i]!, 1e-10));
});

test('as many live as may, when each lives its time', () => {
  const { system } = systemOf({ most: 10, lifetime: 5 });
  run(system, 2.45);
  assert.equal(system.cloud.count, 5);
  run(system, 10);
  assert.equal(system.cloud.count, 10);
});

test('particles stand oldest first, each born at its own time', () => {
  const { system } = systemOf({ most: 100, lifetime: 1, lifetimeVariation: 0.5 });
  run(system, 3);
  const born = [...system.cloud.born.subarray(0, system.cloud.count)];
  assert.deepEqual(
    born,
    born.toSorted((a, b) => a - b),
  );
  for (const time of born) close(time * 100, Math.round(time * 100), 1e-9);
});

test('never do more live than may, however their lives vary', () => {
  const { system } = systemOf({ most: 37, lifetime: 0.7, lifetimeVariation: 1 });
  let most = 0;
  for (let i = 0; i < 1000; i++) {
    system.step(1 / 60);
    most = Math.max(most, system.cloud.count);
  }
  assert.ok(most <= 37 && most > 30, `${most}`);
});

test('lives vary evenly about what is asked for', () => {
  const { system } = systemOf({
    most: 20_000,
    lifetime: 100,
    lifetimeVariation: 0.25,
    atOnce: true,
  });
  system.step(1 / 60);
  const { count, ends, born } = system.cloud;
  const lives = Array.from({ length: count }, (_, k) => ends[k]! - born[k]!);
  const mean = lives.reduce((sum, life) => sum + life) / count;
  const variance = lives.reduce((sum, life) => sum + (life - mean) ** 2, 0) / count;
  close(mean, 100, 0.5);
  close(variance, 25 ** 2 / 3, 0.03 * 25 ** 2);
  assert.ok(Math.min(...lives) >= 75 && Math.max(...lives) <= 125);
});

test('the same particles are at the same places at every level, whirling wind and all', () => {
  const at = (dt: number): number[] => {
    const { system } = systemOf({
      most: 50,
      lifetime: 0.8,
      lifetimeVariation: 0.5,
      emitter: various,
      mass: 0.1,
      surfaceArea: 0.01,
      damping: 0.3,
      winds: [
        { direction: [1, 0, 0], speed: 5, gustiness: 0.5, turbulence: 0.4 },
        { direction: [0, 0, 0], speed: 2, gustiness: 0, turbulence: 0 },
      ],
    });
    run(system, 2, dt);
    return motionOf(system);
  };
  const coarse = at(1 / 60);
  assert.ok(coarse.length > 30 * PARTICLE);
  for (const dt of STEPS) {
    const fine = at(dt);
    assert.equal(fine.length, coarse.length);
    fine.forEach((x, i) => close(x, coarse[i]!, 1e-9));
  }
});

test('a wind pushes by the square of its speed, its gusts by their own', () => {
  const [speed, gustiness, area] = [4, 0.6, 0.02];
  const { system } = systemOf({
    most: 1,
    lifetime: 1e4,
    mass: 0.5,
    surfaceArea: area,
    winds: [{ direction: [0, 0, 2], speed, gustiness, turbulence: 0 }],
  });
  run(system, 200);
  const push = ((0.64615 * area) / 0.5) * speed ** 2 * (1 + gustiness ** 2 / 3);
  const [, , , vx, vy, vz] = motionOf(system) as [number, number, number, number, number, number];
  close((vz - 5) / 200, push, 0.01 * push);
  close(vx, 3, 1e-9);
  close(vy, 4, 1e-9);
});

test('turbulence turns the wind of each particle within its cone', () => {
  const { system } = systemOf({
    most: 2000,
    atOnce: true,
    emitter: { emit: (_, birth) => !!birth.fill(0) },
    winds: [{ direction: [1, 0, 0], speed: 1, gustiness: 0, turbulence: 0.25 }],
    surfaceArea: 1,
  });
  // Two steps: those that are born at the end of the first one have not moved in it.
  run(system, 2 / 60);
  const { count, motion } = system.cloud;
  let mean = 0;
  for (let k = 0; k < count; k++) mean += motion[k * PARTICLE + 3]! / count;
  // Evenly over a cap of half angle π/4.
  const push = 0.64615 * ((1 + Math.SQRT1_2) / 2);
  close(mean, (push * 2) / 60, 0.01 * push * (2 / 60));
});

test('without createParticles those that live go on, and then it is over', () => {
  const { system, say } = systemOf({ most: 10, lifetime: 1 });
  run(system, 2);
  say({ creates: false });
  run(system, 0.5);
  assert.equal(system.cloud.count, 5);
  assert.equal(system.active, true);
  run(system, 0.6);
  assert.equal(system.cloud.count, 0);
  assert.equal(system.active, false);
  say({ creates: true });
  run(system, 0.25);
  assert.equal(system.cloud.count, 3);
});

test('not enabled it has no particles; enabled again it begins anew', () => {
  const { system, say } = systemOf({ most: 10, lifetime: 1 });
  run(system, 2);
  say({ enabled: false });
  assert.equal(system.active, false);
  system.step(1 / 60);
  assert.equal(system.cloud.count, 0);
  say({ enabled: true });
  run(system, 0.35);
  assert.equal(system.cloud.count, 4);
});

test('an explosion throws all at once, and once', () => {
  const { system, say } = systemOf({ most: 25, lifetime: 1, atOnce: true });
  system.step(1 / 60);
  assert.equal(system.cloud.count, 25);
  run(system, 1.1);
  assert.equal(system.cloud.count, 0);
  assert.equal(system.active, false);
  say({ creates: false });
  system.step(1 / 60);
  say({ creates: true });
  system.step(1 / 60);
  assert.equal(system.cloud.count, 25);
});

test('what comes late begins then: nothing is born of the time before', () => {
  for (const [before, after] of [
    [{ emitter: undefined }, { emitter: PLAIN.emitter }],
    [{ most: 0 }, { most: 100 }],
    [{ lifetime: 0 }, { lifetime: 1 }],
    [
      { atOnce: true, lifetime: 0.1 },
      { atOnce: false, lifetime: 1 },
    ],
  ] as const) {
    const { system, say } = systemOf({ most: 100, lifetime: 1, ...before });
    run(system, 3);
    say(after);
    system.step(1 / 120);
    assert.ok(system.cloud.count <= 1, `${system.cloud.count}`);
    run(system, 0.5);
    assert.ok(system.cloud.count > 45, `${system.cloud.count}`);
  }
});

test('lives that are shorter than a step are the same ones at every level', () => {
  for (const dt of STEPS) {
    const { system } = systemOf({ most: 100, lifetime: 0.006 });
    run(system, 0.5, dt);
    assert.ok(system.cloud.count >= 99, `${system.cloud.count} at ${dt}`);
  }
});

test('of more than may live from now on the youngest stay', () => {
  const { system, say } = systemOf({ most: 100, lifetime: 1 });
  run(system, 2);
  const born = [...system.cloud.born.subarray(0, system.cloud.count)];
  say({ most: 10, creates: false });
  system.step(1e-6);
  assert.deepEqual([...system.cloud.born.subarray(0, system.cloud.count)], born.slice(-10));
});

test('who looks changes nothing', () => {
  const counts = [false, true].map((looks) => {
    const { system, say } = systemOf({ most: 100, lifetime: 1 });
    run(system, 2);
    say({ enabled: false });
    if (looks) assert.deepEqual([system.count, system.active], [0, false]);
    if (looks) system.save();
    say({ enabled: true });
    if (looks) assert.equal(system.active, true);
    system.step(1 / 60);
    return system.cloud.count;
  });
  assert.equal(counts[0], counts[1]);
});

test('after hours the gusts of every level are the same, however the seconds were added up', () => {
  const pushes = [-3e-6, 0, 3e-6].map((off) => {
    const { system } = systemOf({
      most: 1,
      lifetime: 1e6,
      surfaceArea: 1,
      winds: [{ direction: [1, 0, 0], speed: 3, gustiness: 0.9, turbulence: 0 }],
    });
    system.step(1 / 60);
    system.load({ ...system.save(), time: 7200 + off });
    const before = motionOf(system)[3]!;
    system.step(1 / 60);
    return motionOf(system)[3]! - before;
  });
  assert.equal(pushes[0], pushes[1]);
  assert.equal(pushes[2], pushes[1]);
});

test('an explosion of short lives throws as many, and the same ones, at every level', () => {
  const thrownAt = (dt: number): number => {
    const { system } = systemOf({ most: 100, lifetime: 0.05, lifetimeVariation: 1, atOnce: true });
    system.step(dt);
    return Math.max(...system.cloud.numbers.subarray(0, system.cloud.count));
  };
  for (const dt of STEPS) assert.ok(thrownAt(dt) < 100);
});

test('begun anew an explosion throws again', () => {
  const { system } = systemOf({ most: 25, lifetime: 1, atOnce: true });
  run(system, 0.5);
  system.reset();
  system.step(1 / 60);
  assert.equal(system.cloud.count, 25);
});

test('what its author changes acts on those that are born from then on, at the new rate', () => {
  const { system, say } = systemOf({ most: 1, lifetime: 100 });
  run(system, 1);
  assert.equal(system.cloud.count, 1);
  say({ most: 100 });
  run(system, 2.5);
  assert.equal(system.cloud.count, 3);
});

test('saying the same again in each step makes no more of them', () => {
  const { system, say } = systemOf({ most: 10, lifetime: 5 });
  for (let i = 0; i < 147; i++) {
    say({ force: [0, i, 0] });
    system.step(1 / 60);
  }
  assert.equal(system.cloud.count, 5);
});

test('nothing is born where nothing lives, nothing may live, or there is nowhere to be born', () => {
  for (const settings of [
    { lifetime: 0 },
    { most: 0 },
    { emitter: undefined },
    { emitter: { emit: () => false } },
  ]) {
    const { system } = systemOf(settings);
    run(system, 1);
    assert.equal(system.cloud.count, 0, Object.keys(settings)[0]);
  }
});

test('a step bears no more than may live, however short they live', () => {
  let born = 0;
  const { system } = systemOf({
    most: 1000,
    lifetime: 0.02,
    lifetimeVariation: 1,
    emitter: {
      emit() {
        born++;
        return true;
      },
    },
  });
  system.step(1);
  assert.ok(born <= 1000, `${born}`);
});

test('goes on from what it kept, bit for bit', () => {
  const settings: Partial<Settings> = {
    most: 60,
    lifetime: 0.9,
    lifetimeVariation: 0.4,
    emitter: various,
    mass: 0.1,
    surfaceArea: 0.02,
    winds: [{ direction: [0, 0, 1], speed: 3, gustiness: 0.5, turbulence: 0.5 }],
  };
  const { system } = systemOf(settings);
  run(system, 1.3);
  const kept = JSON.parse(JSON.stringify(system.save())) as ReturnType<ParticleSystem['save']>;
  run(system, 1);
  const { system: other } = systemOf(settings);
  run(other, 0.2);
  other.load(kept);
  run(other, 1);
  assert.deepEqual(motionOf(other), motionOf(system));
  assert.ok(system.cloud.count > 40);
});

test('begun anew it is the same, bit for bit; with another seed it is another', () => {
  const settings = { most: 60, lifetime: 0.9, lifetimeVariation: 0.4, emitter: various };
  const { system, say } = systemOf(settings);
  run(system, 1);
  const first = motionOf(system);
  system.reset();
  run(system, 1);
  assert.deepEqual(motionOf(system), first);
  say({ seed: 2 });
  system.reset();
  run(system, 1);
  assert.notDeepEqual(motionOf(system), first);
});

test('who hears the same again in each step bears the same, to the bit', () => {
  const often = { emitter: various, most: 200, lifetime: 5 };
  const [once, again] = [systemOf(often), systemOf(often)];
  for (let i = 0; i < 300; i++) {
    again.say({});
    for (const { system } of [once, again]) system.step(1 / 60);
    assert.deepEqual(motionOf(again.system), motionOf(once.system));
  }
});
