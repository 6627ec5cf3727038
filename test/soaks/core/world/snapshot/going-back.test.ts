import assert from 'node:assert/strict';
import { World } from '../../../../../physics-core/inside.js';
import { dense } from '../../../../../physics-core/world/snapshot/dense.js';
import { copyInto } from '../../../../../physics-core/world/snapshot/copy.js';
import type { Snapshot } from '../../../../../physics-core/index.js';
import {
  addBody,
  addFloor,
  addJoint,
  box,
  claim,
  codes,
  fact,
  random,
  sphere,
  world,
  type Body,
} from '../../../../core/helpers.js';

// The run after a restore is the run that was seen, to the last bit: here, and in a world made of the snapshot.

const STEPS = 30;

/** Everything that moves, to the last bit. */
const stateOf = (of: World): number[] =>
  [...of.bodies]
    .sort((a, b) => a.id - b.id)
    .flatMap((body) => [
      ...body.readPose(new Float64Array(7)),
      ...of.bodies.velocityOf(body),
      +body.sleeping,
    ]);

function runOf(of: World, each: (step: number) => void = () => {}): number[][] {
  const states = [stateOf(of)];
  for (let step = 0; step < STEPS; step++) {
    each(step);
    of.step();
    states.push(stateOf(of));
  }
  return states;
}

/** As a file keeps it. */
const kept = (of: World): Snapshot => JSON.parse(JSON.stringify(of.snapshot())) as Snapshot;

function heap(w: World, count: number, shapes: unknown[] = [box(0.5)]): void {
  addFloor(w);
  const next = random(7);
  const side = Math.ceil(Math.cbrt(count));
  for (let i = 0; i < count; i++)
    addBody(w, {
      position: [
        (i % side) * 0.95 + next() * 0.05,
        0.6 + Math.floor(i / side ** 2) * 0.95,
        (Math.floor(i / side) % side) * 0.95 + next() * 0.05,
      ],
      orientation: [next(), next(), next() + 0.1, next() * 3],
      geometry: [shapes[i % shapes.length]],
    });
}

/** Five links by joints of three kinds, which fall onto the floor and each other. */
function ragdolls(w: World): void {
  addFloor(w);
  for (let k = 0; k < 2; k++) {
    let last: Body | undefined;
    for (let i = 0; i < 5; i++) {
      const link = addBody(w, {
        position: [0.2 * k + i * 0.5, 0.6 + k * 0.6, 0],
        geometry: [box(0.45, 0.2, 0.2)],
      });
      const anchorPoint = [0.2 * k + i * 0.5 - 0.25, 0.6 + k * 0.6, 0];
      const fields = { body1: last, body2: link, anchorPoint };
      if (last && i % 2 === 0) addJoint(w, 'BallJoint', fields);
      else if (last)
        addJoint(w, 'SingleAxisHingeJoint', {
          ...fields,
          axis: [0, 0, 1],
          minAngle: -0.5,
          maxAngle: 0.7,
          stopBounce: 0.3,
        });
      last = link;
    }
  }
}

/** Driven wheels on soft struts run over blocks. */
function car(w: World): void {
  addFloor(w);
  const chassis = addBody(w, { position: [0, 1, 0], mass: 500, geometry: [box(3, 0.5, 1.5)] });
  for (const [x, z] of [
    [-1.2, -0.9],
    [1.2, -0.9],
    [-1.2, 0.9],
    [1.2, 0.9],
  ]) {
    const wheel = addBody(w, { position: [x, 0.6, z], mass: 20, geometry: [sphere(0.4)] });
    addJoint(w, 'DoubleAxisHingeJoint', {
      body1: chassis,
      body2: wheel,
      anchorPoint: [x, 0.6, z],
      axis1: [0, 1, 0],
      axis2: [0, 0, 1],
      minAngle1: 0,
      maxAngle1: 0,
      suspensionForce: 1e-3,
      suspensionErrorCorrection: 0.3,
      desiredAngularVelocity2: 4,
      maxTorque2: 200,
    });
  }
  for (let i = 0; i < 4; i++)
    addBody(w, {
      position: [2 + i, 0.1, -0.8],
      geometry: [box(0.3, 0.2, 0.4)],
      fixed: i % 2 === 0,
    });
}

/** Boxes that tumble over a mesh of many triangles, which stands beside a box in one body. */
function rubble(w: World): void {
  const side = 12;
  const coord = Array.from({ length: side * side }, (_, i) => [
    (i % side) * 0.3 - 1.8,
    Math.sin(i * 1.7) * 0.08,
    Math.floor(i / side) * 0.3 - 1.8,
  ]).flat();
  const index: number[] = [];
  for (let i = 0; i < side * (side - 1); i++)
    if (i % side < side - 1) index.push(i, i + side, i + 1, i + 1, i + side, i + side + 1);
  addBody(w, {
    fixed: true,
    geometry: [
      { type: 'IndexedTriangleSet', coord, index, translation: [0, 0.1, 0] },
      { type: 'Box', size: [1, 0.4, 1], translation: [3, 0, 0] },
    ],
  });
  for (let i = 0; i < 5; i++)
    addBody(w, {
      position: [i * 0.6 - 1.2, 0.7, 0.3 * (i % 3) - 0.3],
      linearVelocity: [1.5, 0, 0.5],
      angularVelocity: [0, 1, 4],
      geometry: [box(0.4)],
    });
}

/** A ball deep in a plate and a ring, two meshes of one body. */
function plates(w: World): void {
  addBody(w, {
    fixed: true,
    position: [0, 0, 1.6],
    geometry: [
      {
        type: 'Disk2D',
        innerRadius: 0.09,
        outerRadius: 1,
        translation: [0.8, 0.2, -0.9],
        rotation: [0.6, 0.85, 0.37, -3.27],
      },
      { type: 'Cylinder', radius: 0.64, height: 0.13, top: false },
    ],
  });
  addBody(w, {
    position: [0.7, 2.5, 2],
    orientation: [1, 0, -0.28, 0.01],
    angularVelocity: [2.2, 2.3, 3.9],
    geometry: [{ ...sphere(3), linear: [1, 0, 0, 0, 2, 0, 0, 0, 0.5] }],
  });
  claim(w, 'initial-overlap');
}

/** A box on the ground hangs by a bar on a hinge that is made anew: the first of two joints of that bar. */
function bar(w: World): void {
  addFloor(w, -2.5);
  const rod = addBody(w, {});
  const load = addBody(w, { position: [0, -2.25, 2], geometry: [box(0.5)] });
  const hinge = addJoint(w, 'SingleAxisHingeJoint', { body2: rod });
  addJoint(w, 'BallJoint', { body1: rod, body2: load, anchorPoint: [1.944, 1.426, -1.386] });
  w.step();
  hinge.set('anchorPoint', [-1.871, 0.444, -0.561]);
  w.step();
}

const round = [box(0.5), sphere(0.3), { type: 'Cylinder', radius: 0.25, height: 0.6 }];

for (const [name, level, seconds, restores, build] of [
  ['boxes that tumble at game', 'game', 0.6, 2, (w) => heap(w, 24)],
  ['boxes that tumble at standard', 'standard', 0.6, 2, (w) => heap(w, 24)],
  ['a heap of boxes, balls and cylinders', 'standard', 1, 2, (w) => heap(w, 15, round)],
  ['ragdolls', 'standard', 0.5, 2, ragdolls],
  ['boxes on a mesh that is a part of a body', 'game', 0.6, 2, rubble],
  ['a ball in two meshes of one body', 'reference', 1 / 960, 2, plates],
  ['a bar whose first joint was made anew', 'fine', 1 / 60, 2, bar],
  ['a car on its suspension', 'standard', 0.7, 10, car],
  ['a car on its suspension at game', 'game', 0.7, 2, car],
] as [string, string, number, number, (w: World) => void][])
  fact(
    `${name}: ${restores} restores of one snapshot and a world made of it run as it was seen`,
    async () => {
      const w = await world({ accuracy: level, rest: 'auto' });
      build(w);
      w.advance(seconds);
      const snapshot = kept(w);
      const seen = runOf(w);
      for (let i = 0; i < restores; i++) {
        w.restore(snapshot);
        assert.deepEqual(runOf(w), seen);
      }
      const copy = new World();
      for (const _ of copyInto(copy, snapshot, w.engine));
      assert.deepEqual(runOf(copy), seen);
      copy.destroy();
    },
  );

fact('who takes hold again goes on dragging as he did', async () => {
  const w = await world();
  addFloor(w);
  const [first] = [0, 1, 2].map((i) =>
    addBody(w, { position: [i * 0.6, 0.25, 0], geometry: [box(0.5)] }),
  );
  let drag = first!.drag([0, 0.4, 0])!;
  const pull = (step: number): void => drag.move([0.05 * step, 0.6, 0.2]);
  for (let step = 0; step < 20; step++) {
    pull(step);
    w.step();
  }
  const snapshot = kept(w);
  const go = (step: number): void => pull(20 + step);
  const seen = runOf(w, go);
  w.restore(snapshot);
  assert.ok(!drag.held);
  drag = first!.drag([0, 0, 0])!;
  assert.deepEqual(runOf(w, go), seen);
});

fact('what was edited just before and since goes back, too', async () => {
  const w = await world();
  heap(w, 12);
  w.advance(0.5);
  const [, one, two] = [...w.bodies];
  one!.set('mass', 5);
  one!.applyForce([0, 300, 0]);
  one!.applyImpulse([1, 0, 0]);
  two!.teleport([0, 4, 0]);
  const snapshot = kept(w);
  const seen = runOf(w);
  two!.set('geometry', [sphere(0.4)]);
  one!.set('fixed', true);
  w.step(5);
  w.restore(snapshot);
  assert.deepEqual(runOf(w), seen);
});

fact('a restore into the same scene makes and unmakes nothing', async () => {
  const w = await world();
  ragdolls(w);
  w.advance(0.5);
  const snapshot = kept(w);
  const { created, destroyed } = w.stats;
  w.advance(0.5);
  w.restore(snapshot);
  w.step();
  assert.deepEqual([w.stats.created, w.stats.destroyed], [created, destroyed]);
});

fact('who falls asleep after a restore does so in the step in which he did', async () => {
  const w = await world({ rest: 'auto' });
  heap(w, 3);
  w.advance(2.5);
  const snapshot = kept(w);
  const seen: number[] = [];
  const sleepers = (): number => [...w.bodies].filter((body) => body.sleeping).length;
  for (let step = 0; step < 240; step++) seen.push((w.step(), sleepers()));
  assert.equal(seen.at(-1), 3);
  w.restore(snapshot);
  for (let step = 0; step < 240; step++) assert.equal((w.step(), sleepers()), seen[step]);
});

fact('a world so busy that boxes are left to Bullet begins anew as it began', async () => {
  const w = await world();
  addFloor(w);
  for (let i = 0; i < 300; i++)
    addBody(w, {
      position: [
        (i % 10) * 0.52,
        0.3 + Math.floor(i / 100) * 0.52,
        (Math.floor(i / 10) % 10) * 0.52,
      ],
      angularVelocity: [i % 3, 0, i % 2],
      geometry: [box(0.5)],
    });
  w.step(10);
  const seen = stateOf(w);
  w.reset();
  w.step(10);
  assert.deepEqual(stateOf(w), seen);
});

// ---- what is none -------------------------------------------------------------------------------------------------------

/** What stands for its bodies, as something else. */
const withBodies = (s: Snapshot, change: (text: string) => string): Snapshot => ({
  ...s,
  bodies: change(s.bodies as string),
});

/** With a body that is nowhere. */
function withNaN(text: string): string {
  const moment = dense.code.unpack(text);
  moment.states[20] = NaN;
  return dense.code.pack(moment, 0);
}

for (const [what, spoil] of [
  ['of an earlier version', (s) => ({ ...s, x3dPhysics: 3 })],
  ['cut off', (s) => ({ ...s, nodes: undefined, effects: undefined })],
  ['whose bodies are cut in half', (s) => withBodies(s, (text) => text.slice(0, text.length / 2))],
  ['whose last contact is cut off', (s) => withBodies(s, (text) => text.slice(0, -4))],
  ['whose text is torn', (s) => withBodies(s, (text) => text.slice(1))],
  ['whose effects are cut', (s) => ({ ...s, effects: { rest: s.effects.rest } })],
  ['with a time that is not a number', (s) => ({ ...s, time: NaN })],
  ['with a body that is nowhere', (s) => withBodies(s, withNaN)],
  [
    'with a field that is not a number',
    (s) => JSON.parse(JSON.stringify(s).replace(/("position":.*?"each":\[)/, '$1null,')),
  ],
] as [string, (s: Snapshot) => unknown][])
  fact(`a snapshot ${what} is one problem, and the world as it was`, async () => {
    const w = await world();
    claim(w, 'bad-value');
    heap(w, 6);
    w.advance(0.6);
    const spoilt = spoil(kept(w));
    w.advance(0.1);
    const at = stateOf(w);
    w.restore(spoilt as Snapshot);
    assert.deepEqual(stateOf(w), at);
    assert.deepEqual(codes(w), ['bad-value']);
  });

fact('a snapshot of another scene is one problem, and the world as it was', async () => {
  const [w, other] = [await world(), await world()];
  claim(w, 'bad-value');
  heap(w, 6);
  car(other);
  w.advance(0.2);
  other.advance(0.2);
  const at = stateOf(w);
  w.restore(other.snapshot());
  assert.deepEqual(stateOf(w), at);
  assert.deepEqual(codes(w), ['bad-value']);
});
