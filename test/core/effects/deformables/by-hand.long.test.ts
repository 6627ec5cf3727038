import assert from 'node:assert/strict';
import type { CreateOptions } from '../../../../physics-core/create.js';
import type { World } from '../../../../physics-core/inside.js';
import type { SoftNode } from '../../../../physics-core/nodes/soft/soft-node.js';
import {
  above,
  addBody,
  addFloor,
  below,
  box,
  close,
  distance,
  fact,
  position,
  sphere,
  world,
  type Vec3,
} from '../../helpers.js';
import { addCloth, G, place, places, tie } from './helpers.js';

/** rad/s: how stiff a hand holds. */
const SWIFTNESS = 30;

/** Upright, a metre square, of ten by ten cells; its upper corners. */
const SHEET = { size: [1, 1], subdivision: [10, 10], mass: 0.3, damping: 1 };
const [LEFT, RIGHT] = [110, 120];

const cloth = (of: World, fields: Record<string, unknown> = {}): SoftNode =>
  addCloth(of, { ...SHEET, ...fields }) as SoftNode;

/** All of it, kg m/s, as its last two steps say: points by what they weigh in such a sheet. */
function momentum(before: readonly Vec3[], now: readonly Vec3[], seconds: number): Vec3 {
  const sum: Vec3 = [0, 0, 0];
  now.forEach((p, i) => {
    const [x, y] = [i % 11, Math.floor(i / 11)];
    const share = (x % 10 ? 1 : 0.5) * (y % 10 ? 1 : 0.5);
    for (let k = 0; k < 3; k++)
      sum[k]! += (share * SHEET.mass * (p[k]! - before[i]![k]!)) / (100 * seconds);
  });
  return sum;
}

fact('a cloth hangs in a hand by its corner, lower by its weight, as bodies do', async () => {
  const w = await world();
  const sheet = cloth(w, { damping: 4 });
  const drag = sheet.drag([0.5, 0.5, 0])!;
  w.advance(6);
  close(place(sheet, RIGHT), [0.5, 0.5 - G / SWIFTNESS ** 2, 0], 2e-3, 'its corner');
  close(drag.point, place(sheet, RIGHT), 1e-9, 'what is held');
  assert.equal(drag.mode, 'spring');
});

fact('it follows the hand', async () => {
  const w = await world();
  const sheet = cloth(w, { damping: 4 });
  const drag = sheet.drag([0.5, 0.5, 0])!;
  w.advance(2);
  drag.move([1.5, 1, 0.5]);
  w.advance(0.5);
  below(distance(drag.point, [1.5, 1 - G / SWIFTNESS ** 2, 0.5]), 0.02, 'off after half a second');
  w.advance(4);
  below(distance(drag.point, [1.5, 1 - G / SWIFTNESS ** 2, 0.5]), 2e-3, 'off in the end');
});

fact('it is held where it is taken, between its points, too', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const sheet = cloth(w);
  const drag = sheet.drag([0.13, 0.07, 0.02])!;
  close(drag.point, [0.13, 0.07, 0.02], 1e-12, 'taken');
  drag.move([0.13, 0.07, 0.52]);
  w.advance(3);
  close(drag.point, [0.13, 0.07, 0.52], 1e-3, 'held');
});

fact('let go it goes on with what it had, and falls', async () => {
  const w = await world();
  const sheet = cloth(w, { damping: 0 });
  const drag = sheet.drag([0.5, 0.5, 0])!;
  drag.move([2, 1, 0]);
  w.advance(0.25);
  w.step();
  const seen = [places(sheet)];
  w.step();
  seen.push(places(sheet));
  drag.end();
  w.step();
  w.step();
  seen.push(places(sheet));
  w.step();
  seen.push(places(sheet));
  const dt = w.timeStep;
  const held = momentum(seen[0]!, seen[1]!, dt);
  const free = momentum(seen[2]!, seen[3]!, dt);
  // Three steps on.
  close(free[0], held[0], 0.01 * held[0], 'along x, kg m/s');
  close(free[1], held[1] - 3 * dt * G * SHEET.mass, 0.005, 'along y, kg m/s');
  const from = place(sheet, RIGHT)[1];
  w.advance(2);
  below(place(sheet, RIGHT)[1], from - 2, 'fallen to');
});

fact('let go still it flies on no further: it only falls', async () => {
  const w = await world();
  const sheet = cloth(w);
  const drag = sheet.drag([0.5, 0.5, 0])!;
  drag.move([3, 1, 0]);
  w.advance(0.3);
  drag.end(true);
  const [x] = sheet.centerOfMassWorld();
  w.advance(0.5);
  close(sheet.centerOfMassWorld()[0], x, 0.01, 'm');
});

fact('a hand that stays moves nothing', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const sheet = cloth(w, { damping: 0 });
  w.step(0);
  const before = places(sheet);
  sheet.drag([0, 0, 0]);
  w.advance(1);
  places(sheet).forEach((p, i) => below(distance(p, before[i]!), 1e-4, 'm'));
});

fact(
  'a flat cloth that is pushed together within its plane folds, and falls open again',
  async () => {
    const w = await world();
    const sheet = cloth(w, { fixedIndex: [LEFT, RIGHT] });
    w.advance(1);
    const from = place(sheet, 15);
    const drag = sheet.drag(from)!;
    for (let i = 1; i <= 10; i++) {
      drag.move([from[0] + 0.03 * i, from[1] + 0.05 * i, 0]);
      w.advance(0.04);
    }
    w.advance(1);
    above(Math.max(...places(sheet).map(([, , z]) => Math.abs(z))), 0.05, 'out of its plane, m');
    drag.end();
    w.advance(3);
    close(place(sheet, 15), from, 0.05, 'it hangs as it did');
  },
);

fact('what is pinned stays: the nearest that is free is held', async () => {
  const w = await world();
  const sheet = cloth(w, { fixedIndex: [LEFT, RIGHT] });
  const pinned = place(sheet, RIGHT);
  const drag = sheet.drag(pinned)!;
  drag.move([3, 3, 3]);
  w.advance(1);
  assert.deepEqual(place(sheet, RIGHT), pinned);
  above(distance(drag.point, pinned), 0.01, 'the cloth beside it gives way, m');
  const all = cloth(w, { fixedIndex: places(sheet).map((_, i) => i) });
  assert.equal(all.drag([0, 0, 0]), undefined);
});

fact('a hand is only so strong: it stretches no cloth that is pinned', async () => {
  const w = await world();
  const sheet = cloth(w, { fixedIndex: [LEFT, RIGHT] });
  const drag = sheet.drag(place(sheet, 0))!;
  drag.move([-5, 3, 2]);
  let most = 0;
  for (let i = 0; i < 240; i++) {
    w.step();
    const now = places(sheet);
    for (let j = 0; j < 121; j++)
      if (j % 11) most = Math.max(most, distance(now[j]!, now[j - 1]!) / 0.1 - 1);
  }
  below(most, 0.1, 'longest thread, as a share');
  assert.deepEqual(w.problems, []);
});

fact('two hands stretch it out between them', async () => {
  const w = await world();
  const sheet = cloth(w, { damping: 4 });
  sheet.drag(place(sheet, LEFT));
  sheet.drag(place(sheet, RIGHT))!.move([0.4, 0.5, 0]);
  w.advance(4);
  const lower = G / SWIFTNESS ** 2 / 2;
  close(place(sheet, LEFT)[1], 0.5 - lower, 3e-3, 'left');
  close(place(sheet, RIGHT)[1], 0.5 - lower, 3e-3, 'right');
});

fact('what is tied to it is lifted with it', async () => {
  const w = await world();
  const sheet = cloth(w, { damping: 4 });
  const ball = addBody(w, { position: [0, -0.6, 0], mass: 1, geometry: [sphere(0.1)] });
  tie(w, sheet, 5, { body: ball, position: [0, 0.1, 0] });
  const drag = sheet.drag([0, 0.5, 0])!;
  drag.move([0, 1.5, 0]);
  w.advance(6);
  close(drag.point[1], 1.5 - G / SWIFTNESS ** 2, 5e-3, 'held');
  close(position(ball)[1], 0.4, 0.03, 'the ball');
});

fact('a soft body is carried, and stands where it is set down', async () => {
  const w = await world();
  addFloor(w, 0);
  const cube = w.add('SoftBody', {
    geometry: { ...box(0.4), translation: [0, 0.2, 0] },
    mass: 1,
    damping: 2,
    youngsModulus: 5e3,
  }) as unknown as SoftNode;
  w.step(10);
  const drag = cube.drag([0, 0.4, 0])!;
  drag.move([1, 1, 0]);
  w.advance(2);
  const hung = cube.centerOfMassWorld();
  close(drag.point, [1, 1 - G / SWIFTNESS ** 2, 0], 5e-3, 'held');
  below(hung[1], 0.9, 'its middle hangs below');
  drag.move([1, 0.4, 0]);
  w.advance(1);
  drag.end();
  w.advance(2);
  close(cube.centerOfMassWorld()[1], 0.2, 0.03, 'stands');
  close(cube.centerOfMassWorld()[0], 1, 0.1, 'there');
});

fact('what rests is woken, and what is held never rests', async () => {
  const w = await world({ rest: 'auto' });
  addFloor(w, 0);
  const sheet = cloth(w, { thickness: 0.02, size: [0.2, 0.2], subdivision: [2, 2] });
  w.advance(12);
  const lying = place(sheet, 4);
  w.advance(1);
  assert.deepEqual(place(sheet, 4), lying, 'it rests');
  const drag = sheet.drag(lying)!;
  w.advance(6);
  drag.move([0, 1, 0]);
  w.advance(1);
  close(drag.point[1], 1 - G / SWIFTNESS ** 2, 0.02, 'lifted');
});

for (const [what, reason, act] of [
  ['it is taken out', 'removed', (_, sheet) => sheet.remove()],
  ['it is laid anew', 'reset', (_, sheet) => sheet.set('size', [2, 2])],
  ['the world begins anew', 'reset', (w) => w.reset()],
  ['it goes back', 'reset', (w) => w.restore(w.snapshot())],
  ['it stands still', 'disabled', (_, sheet) => sheet.set('enabled', false)],
  ['nobody may drag it', 'disabled', (w) => w.set('draggableBody', false)],
] as [string, string, (w: World, sheet: SoftNode) => void][])
  fact(`a drag is over once ${what}`, async () => {
    const w = await world({ draggableBody: true } as CreateOptions);
    const sheet = cloth(w);
    w.step();
    const reasons: string[] = [];
    const drag = sheet.drag([0, 0, 0], (why) => reasons.push(why))!;
    w.step();
    act(w, sheet);
    w.step();
    drag.move([1, 0, 0]);
    assert.deepEqual(reasons, [reason]);
    assert.equal(drag.held, false);
    drag.end();
    drag.cancel();
    assert.deepEqual(reasons, [reason]);
  });

/** A cloth and a rope that somebody drags for a second, to and fro. */
async function dragged(then: (w: World, i: number) => void): Promise<number[]> {
  const w = await world();
  const sheet = cloth(w, { fixedIndex: [LEFT] });
  const rope = w.add('Rope', { points: [[2, 0, 0], [3, 0, 0]], segments: 10, mass: 0.1 }); // prettier-ignore
  then(w, -1);
  w.step(10);
  const one = sheet.drag([0.5, -0.5, 0])!;
  const other = (rope as SoftNode).drag([2.52, 0, 0.01])!;
  for (let i = 0; i < 60; i++) {
    one.move([0.5 + i / 60, -0.5, i / 100]);
    other.move([2.5, i / 60, 0]);
    w.step();
    then(w, i);
  }
  one.end();
  other.end();
  w.step(30);
  then(w, 60);
  return [...places(sheet).flat(), ...places(rope).flat()];
}

fact('the same is done to the last bit, and what is recorded is run anew with it', async () => {
  const once = await dragged(() => {});
  assert.deepEqual(await dragged(() => {}), once);
  const w = await world();
  const sheet = cloth(w, { fixedIndex: [LEFT] });
  const timeline = await w.record({ seconds: 10 });
  w.step(10);
  const drag = sheet.drag([0.5, -0.5, 0])!;
  const seen: Vec3[][] = [];
  for (let i = 0; i < 60; i++) {
    drag.move([0.5 + i / 60, -0.5, i / 100]);
    w.step();
    seen.push(places(sheet));
  }
  drag.end();
  w.step(60);
  for (const step of [64, 40]) {
    timeline.seek(step * w.timeStep);
    timeline.pause();
    w.resume();
    assert.deepEqual(places(sheet), seen[step - 11], `run anew to step ${step}`);
  }
});

fact('who takes hold again where a snapshot was taken holds it as it was held', async () => {
  const w = await world();
  const sheet = cloth(w);
  const drag = sheet.drag([0.5, 0.5, 0])!;
  drag.move([2, 1, 0]);
  w.step(20);
  const then = w.snapshot();
  w.step(20);
  const first = places(sheet);
  w.restore(then);
  assert.equal(drag.held, false);
  const again = sheet.drag([0.5, 0.5, 0])!;
  w.step(20);
  assert.deepEqual(places(sheet), first);
  again.end();
});

fact('a line of sight meets it where it is', async () => {
  const w = await world();
  const sheet = cloth(w);
  w.step(0);
  const sight = (x: number) =>
    sheet.seen({ from: [x, 0.03, 4], to: [x, 0.03, -4], beside: [0, 0] });
  close(sight(0.2)!, 0.5, 1e-12, 'half-way');
  assert.equal(sight(0.6), undefined);
});
