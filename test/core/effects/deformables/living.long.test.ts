import assert from 'node:assert/strict';
import type { CreateOptions } from '../../../../physics-core/create.js';
import type { Problem, World } from '../../../../physics-core/inside.js';
import {
  addBody,
  addFloor,
  addJoint,
  below,
  box,
  claim,
  close,
  distance,
  fact,
  height,
  position,
  sphere,
  told,
  velocity,
  world,
  type Body,
  type Node,
  type Vec3,
} from '../../helpers.js';
import { addCloth, flat, place, places, tie } from './helpers.js';

/** Upright, of four by four cells, a metre square. */
const UPRIGHT = { size: [1, 1], subdivision: [4, 4] };
const [LEFT, RIGHT] = [20, 24];

/** Cloths that hang, fall, lie, blow in the wind, tear and tie bodies; what is known of all of them. */
function scene(w: World): { state: () => number[]; cloths: Node[]; bodies: Body[] } {
  addFloor(w, -2);
  const bodies = [0, 1, 2].map((i) =>
    addBody(w, {
      position: [3 * i, -0.5, 0],
      mass: 1 + i,
      geometry: [i === 1 ? box(0.2) : sphere(0.1)],
    }),
  );
  addJoint(w, 'BallJoint', { body1: bodies[2], anchorPoint: [6, 0.5, 0] });
  const held = addCloth(w, {
    ...UPRIGHT,
    fixedIndex: [LEFT, 22, RIGHT],
    wind: [0, 0, 3],
    damping: 0.1,
  });
  tie(w, held, 2, { body: bodies[0] });
  const between = addCloth(w, {
    geometry: { ...flat(4, 1, 0.5), translation: [3, 0, 0] },
    thickness: 0.02,
    stretchStiffness: 200,
    fixedIndex: [0, 4, 20, 24],
  });
  addBody(w, { position: [3, 1, 0], mass: 0.3, geometry: [sphere(0.3)] });
  const loose = addCloth(w, {
    geometry: { ...flat(5, 1, -1.5), translation: [-3, 0, 0] },
    thickness: 0.05,
    bendStiffness: 0.01,
  });
  const torn = addCloth(w, {
    geometry: { ...flat(3, 1, 0), translation: [0, 0, 4] },
    stretchStiffness: 20,
    tearStrain: 0.2,
    fixedIndex: [0, 1, 2, 3],
  });
  const cloths = [held, between, loose, torn];
  const state = (): number[] => [
    ...cloths.flatMap((cloth) => places(cloth).flat()),
    ...bodies.flatMap((body) => [...position(body), ...velocity(body)]),
  ];
  return { state, cloths, bodies };
}

/** To the last bit. */
function same(actual: readonly number[], expected: readonly number[]): void {
  assert.equal(actual.length, expected.length);
  const other = actual.findIndex((value, i) => !Object.is(value, expected[i]));
  assert.equal(other, -1, `number ${other} is ${actual[other]}, not ${expected[other]}`);
}

/** Where something is thrown about, what does not stretch does so for a moment, and may say so. */
async function strained(fields: CreateOptions = {}): Promise<World> {
  const w = await world(fields);
  w.on('problem', (problem) => {
    if ((problem as Problem).code === 'soft-too-stiff') claim(w, 'soft-too-stiff');
  });
  return w;
}

// ---- going back --------------------------------------------------------------------------------------------------------

fact('put back to before, cloths go on to the same bits', async () => {
  const w = await strained();
  const { state } = scene(w);
  for (const before of [0.1, 0.3, 0.6, 1.2]) {
    w.advance(before);
    const snapshot = w.snapshot();
    const then = state();
    w.advance(0.7);
    const first = state();
    w.restore(JSON.parse(JSON.stringify(snapshot)));
    same(state(), then);
    w.advance(0.7);
    same(state(), first);
  }
});

fact('after a reset all of it comes about again, what was torn is whole', async () => {
  const w = await strained();
  const { state } = scene(w);
  w.advance(1);
  const first = state();
  w.reset();
  w.advance(1);
  same(state(), first);
});

fact('two worlds of one scene with cloths go the same way to the last bit', async () => {
  const [one, two] = [await strained(), await strained()].map((w) => ({ w, ...scene(w) }));
  one!.w.advance(1.5);
  for (let i = 0; i < 180; i++) two!.w.step();
  same(two!.state(), one!.state());
});

fact('cloths that are recorded go the way they go without', async () => {
  const [plain, kept] = [await strained(), await strained()];
  const [one, two] = [plain, kept].map((w) => scene(w).state);
  await kept.record({ seconds: 10 });
  plain.step(150);
  kept.step(150);
  same(two!(), one!());
});

fact('an exported run of a body on a cloth is run anew in another world', async () => {
  const [one, two] = [await strained(), await strained()];
  const [kept, anew] = [one, two].map((w) => {
    const cloth = addCloth(w, { ...UPRIGHT, fixedIndex: [LEFT, RIGHT] });
    const body = addBody(w, { position: [0, -0.5, 0], geometry: [sphere(0.1)] });
    tie(w, cloth, 2, { body });
    return () => [...places(cloth).flat(), ...position(body)];
  });
  await one.record({ seconds: 10 });
  one.step(150);
  const timeline = (await two.importRun(JSON.parse(JSON.stringify(one.exportRun()))))!;
  assert.deepEqual(timeline.hashes, one.timeline!.hashes);
  same(anew!(), kept!());
});

fact(
  'errors of cloths are measured in copies of the world, which goes on as it would',
  async () => {
    const [w, plain] = [await strained(), await strained()];
    const [state, expected] = [w, plain].map((each) => scene(each).state);
    w.step(60);
    const rows = await w.measureAccuracy({ seconds: 0.2, levels: ['game', 'fine'] });
    assert.deepEqual(
      rows.map(({ level }) => level),
      ['game', 'fine'],
    );
    w.step(60);
    plain.step(120);
    same(state!(), expected!());
  },
);

// ---- on and off ----------------------------------------------------------------------------------------------------------

const effect = (w: World, name = 'deformables') => w.effects.find((each) => each.name === name)!;

fact('cloths are on because of the first, and off without a call when the last goes', async () => {
  const w = await strained();
  const none = effect(w);
  assert.deepEqual([none.active, none.because, none.calls], [false, null, 0]);
  const cloths = [0, 3].map((x) =>
    addCloth(w, {
      geometry: { ...flat(2, 1, 0), translation: [x, 0, 0] },
      fixedIndex: [0, 1, 2, 6, 7, 8],
    }),
  );
  const body = addBody(w, { position: [0, 0, 0], geometry: [sphere(0.1)] });
  tie(w, cloths[0]!, 4, { body });
  w.step(34);
  const on = effect(w);
  assert.equal(on.active, true);
  assert.equal((on.because!.element as Node).id, cloths[0]!.id);
  assert.deepEqual(
    on.elements.map((each) => (each as Node).id),
    cloths.map(({ id }) => id),
  );
  assert.ok(on.calls > 0, 'it was not called');
  cloths[0]!.remove();
  w.step(34);
  assert.equal((effect(w).because!.element as Node).id, cloths[1]!.id);
  assert.equal(effect(w, 'joint solve').active, false);
  cloths[1]!.remove();
  w.step(34);
  const off = effect(w);
  assert.deepEqual([off.active, off.because, off.elements, off.calls], [false, null, [], 0]);
});

fact('FALSE enabled stands still, touches nothing and holds nothing; TRUE goes on', async () => {
  const w = await strained();
  const cloth = addCloth(w, { ...UPRIGHT, fixedIndex: [LEFT, 22, RIGHT] });
  const body = addBody(w, { position: [0, -0.5, 0], geometry: [sphere(0.1)] });
  tie(w, cloth, 2, { body });
  w.advance(0.3);
  cloth.set('enabled', false);
  w.step();
  const before = places(cloth);
  w.advance(0.5);
  same(places(cloth).flat(), before.flat());
  close(height(body), -0.5 - (9.8 / 2) * 0.25, 0.1);
  cloth.set('enabled', true);
  w.advance(3);
  below(distance(position(body), [0, 0.5, 0]), 1.2);
});

fact(
  'coord_changed tells where points of a cloth are after each step, as positions does',
  async () => {
    const w = await strained();
    const cloth = addCloth(w, { ...UPRIGHT, fixedIndex: [LEFT, RIGHT] });
    const heard: Vec3[][] = [];
    cloth.on('coord_changed' as never, ((value: Vec3[]) => heard.push(value)) as never);
    w.step(5);
    assert.equal(heard.length, 5);
    assert.deepEqual(heard.at(-1), places(cloth));
  },
);

// ---- rest --------------------------------------------------------------------------------------------------------------

/** A body that hangs on a cloth, at rest. */
async function atRest(): Promise<{ w: World; cloth: Node; body: Body }> {
  const w = await strained({ rest: 'auto' });
  const cloth = addCloth(w, {
    ...UPRIGHT,
    fixedIndex: [20, 21, 22, 23, 24],
    thickness: 0.04,
    damping: 4,
  });
  const body = addBody(w, { position: [0, -0.5, 0], geometry: [sphere(0.1)] });
  tie(w, cloth, 2, { body });
  w.advance(12);
  assert.ok(body.sleeping, `still ${velocity(body).join()}`);
  return { w, cloth, body };
}

fact(
  'what hangs still falls asleep with its cloth, and the world takes no step any more',
  async () => {
    const { w, cloth, body } = await atRest();
    const [steps, before] = [w.stepsTaken, places(cloth)];
    for (let n = 0; n < 10; n++) w.frame(n / 60);
    assert.equal(w.stepsTaken, steps);
    same(places(cloth).flat(), before.flat());
    close(position(body), [0, -0.5, 0], 0.02);
  },
);

const WAKES: Record<string, (cloth: Node, w: World) => void> = {
  'is let go': (cloth) => cloth.set('fixedIndex', []),
  'is made heavier': (cloth) => cloth.set('mass', 5),
  'is laid anew': (cloth) => cloth.set('size', [1.1, 1]),
  goes: (cloth) => cloth.remove(),
  'is switched off': (cloth) => cloth.set('enabled', false),
  'is tied elsewhere, too': (cloth, w) => tie(w, cloth, 12, { position: [0, 0.02, 0.02] }),
  'feels a wind': (cloth) => cloth.set('wind', [0, 0, 3]),
};

for (const [what, edit] of Object.entries(WAKES))
  fact(`a body that hangs asleep wakes when its cloth ${what}`, async () => {
    const { w, cloth, body } = await atRest();
    edit(cloth, w);
    w.step(2);
    assert.ok(!body.sleeping, 'it sleeps on');
  });

fact('a sleeping cloth wakes when a ball comes against it, and its body with it', async () => {
  const { w, cloth, body } = await atRest();
  const before = place(cloth, 12);
  addBody(w, {
    position: [0, 0, 0.5],
    linearVelocity: [0, 0, -3],
    useGlobalGravity: false,
    geometry: [sphere(0.2)],
  });
  w.advance(0.3);
  assert.ok(distance(place(cloth, 12), before) > 0.01, `${place(cloth, 12).join()}`);
  assert.ok(!body.sleeping, 'it sleeps on');
});

fact('a sleeping cloth wakes with the body that hangs on it', async () => {
  const { w, cloth, body } = await atRest();
  body.applyImpulse([0, 0, 1]);
  w.advance(0.3);
  assert.ok(place(cloth, 2)[2] > 0.05, `${place(cloth, 2).join()}`);
});

const GIVES_WAY: Record<string, (cloth: Node) => void> = {
  goes: (cloth) => cloth.remove(),
  'is switched off': (cloth) => cloth.set('enabled', false),
  'has no thickness any more': (cloth) => cloth.set('thickness', 0),
  'is let go': (cloth) => cloth.set('fixedIndex', []),
};

for (const [what, edit] of Object.entries(GIVES_WAY))
  fact(`a box that lies asleep on a cloth falls when that ${what}`, async () => {
    const w = await strained({ rest: 'auto' });
    const edge = [...Array(25).keys()].filter(
      (i) => ![6, 7, 8, 11, 12, 13, 16, 17, 18].includes(i),
    );
    const cloth = addCloth(w, {
      geometry: flat(4, 1, 0),
      fixedIndex: edge,
      thickness: 0.04,
      damping: 4,
      stretchStiffness: 300,
    });
    const crate = addBody(w, { position: [0, 0.12, 0], geometry: [box(0.6, 0.2, 0.6)] });
    w.advance(20);
    assert.ok(crate.sleeping, `still ${velocity(crate).join()}`);
    edit(cloth);
    w.advance(0.5);
    below(height(crate), -0.5);
  });

fact('a cloth that falls on what sleeps wakes it', async () => {
  const w = await strained({ rest: 'auto' });
  addFloor(w);
  const body = addBody(w, { mass: 0.1, position: [0, 0.2, 0], geometry: [sphere(0.2)] });
  w.advance(6);
  assert.ok(body.sleeping);
  addCloth(w, { geometry: { ...flat(6, 1, 1), translation: [0.3, 0, 0] }, thickness: 0.02 });
  let woke = false;
  for (let i = 0; i < 120 && !woke; i++) {
    w.step();
    woke = !body.sleeping;
  }
  assert.ok(woke, 'it sleeps on');
});

fact('without rest a cloth is within a centimetre of where it is with it', async () => {
  const [one, two] = await Promise.all(
    (['auto', 'never'] as const).map(async (rest) => {
      const w = await strained({ rest });
      const cloth = addCloth(w, { ...UPRIGHT, fixedIndex: [LEFT, RIGHT], damping: 3 });
      w.advance(12);
      return places(cloth);
    }),
  );
  one!.forEach((at, i) => below(distance(at, two![i]!), 1e-2));
});

fact('gravity of its world, edited, acts on a cloth, whether it rests or not', async () => {
  for (const seconds of [0.5, 8]) {
    const w = await strained({ rest: 'auto' });
    const cloth = addCloth(w, {
      ...UPRIGHT,
      fixedIndex: [20, 21, 22, 23, 24],
      damping: 4,
    });
    w.advance(seconds);
    close(place(cloth, 2), [0, -0.5, 0], 1e-2);
    w.settings.set('gravity', [0, 0, 9.8]);
    w.advance(6);
    close(place(cloth, 2), [0, 0.5, 1], 2e-2);
  }
});

// ---- edits while it moves ------------------------------------------------------------------------------------------------

const EDITS: Record<string, readonly unknown[]> = {
  mass: [5, 0.01],
  thickness: [0.1, 0],
  stretchStiffness: [100, 0, 1000],
  shearStiffness: [0, 100],
  bendStiffness: [0.01, 0],
  damping: [3, 0],
  friction: [0, 2],
  fixedIndex: [[LEFT], [], [0, 1], [LEFT, RIGHT]],
  selfCollision: [true, false],
  tearStrain: [0.5, 0],
  wind: [
    [0, 0, 3],
    [0, 0, 0],
  ],
  enabled: [false, true],
};

for (const [field, values] of Object.entries(EDITS))
  fact(`${field}, edited again and again while it hangs, keeps it where it was`, async () => {
    const w = await strained();
    const cloth = addCloth(w, { ...UPRIGHT, fixedIndex: [LEFT, RIGHT], damping: 0.5 });
    goOn(w, cloth, field, values);
  });

/** Each edit changes no place by itself, and no point is elsewhere after the next step than its speed took it. */
function goOn(w: World, cloth: Node, field: string, values: readonly unknown[]): void {
  w.advance(0.3);
  for (let i = 0; i < 3; i++)
    for (const value of values) {
      const before = places(cloth);
      cloth.set(field, value);
      same(places(cloth).flat(), before.flat());
      w.step();
      places(cloth).forEach((at, n) => below(distance(at, before[n]!), 1, `${field} ${n}`));
      w.advance(0.1);
      for (const at of places(cloth)) below(Math.hypot(...at), 30, field);
    }
}

fact('fixedIndex beyond its points is told once, and the others hold', async () => {
  const w = await strained();
  claim(w, 'out-of-range');
  const cloth = addCloth(w, { ...UPRIGHT, fixedIndex: [99, 20, 21, 22, 23, 24] });
  w.step(20);
  assert.equal(told(w, 'out-of-range').length, 1);
  close(place(cloth, 22), [0, 0.5, 0], 1e-9);
});
