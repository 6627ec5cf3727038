import { levelNames } from '../../../physics-core/dynamics/levels.js';
import type { Snapshot, World } from '../../../physics-core/inside.js';
import { Ledger } from '../../fuzz/ledger.js';
import {
  addBody,
  addFloor,
  addJoint,
  below,
  box,
  fact,
  random,
  spin,
  velocity,
  WEIGHTLESS,
  world,
  type Body,
  type Hinge,
  type Vec3,
} from '../../core/helpers.js';

// An edit of what hangs together and touches gives nobody more motion than its author's speeds, falls and forces do.

/** The speed that all bodies together may have beyond four times that, m/s: a step's fall at `game`, 0.067, is the most. */
const UNEXPLAINED = 0.1;

interface Rig {
  w: World;
  links: Body[];
  joints: Hinge[];
  tower: Body[];
}

/** A chain that hangs level, and beneath it a tower that it may fall on. */
async function rig(accuracy: string): Promise<Rig> {
  const w = await world({ accuracy });
  addFloor(w, -2.5);
  const tower = [0, 1, 2].map((i) =>
    addBody(w, { position: [0.3, -2.25 + 0.5 * i, 0], geometry: [box(0.5)], mass: 2 - i / 2 }),
  );
  const links = [0, 1, 2, 3].map((i) =>
    addBody(w, { position: [0.6 * i + 0.3, 0, 0], geometry: [box(0.5, 0.2, 0.2)], mass: 1 + i }),
  );
  const joints = links.map((link, i) =>
    addJoint(w, i % 2 ? 'SingleAxisHingeJoint' : 'BallJoint', {
      body1: link,
      ...(i > 0 && { body2: links[i - 1] }),
      anchorPoint: [0.6 * i, 0, 0],
      ...(i % 2 && { axis: [0, 0, 1] }),
    }),
  );
  return { w, links, joints, tower };
}

/** Plays two seconds with an edit every tenth of a second; the greatest speed that nobody gave, m/s. */
async function unexplained(
  accuracy: string,
  edit: (rig: Rig, count: number, next: () => number) => void,
): Promise<number> {
  const parts = await rig(accuracy);
  const { w } = parts;
  const ledger = new Ledger(w);
  const next = random(5);
  const every = Math.round(0.1 / w.timeStep);
  let most = 0;
  for (let step = 0; step < 20 * every; step++) {
    if (step % every === every - 1)
      ledger.editing(() => edit(parts, Math.floor(step / every), next));
    ledger.beforeStep();
    w.step();
    ledger.afterStep();
    most = Math.max(most, ledger.excessSpeed);
  }
  return most;
}

const somewhere = (next: () => number): Vec3 => [3 * next(), 2 * next() - 2, 2 * next() - 1];

const EDITS: Record<string, (rig: Rig, count: number, next: () => number) => void> = {
  'links put elsewhere': ({ links }, count, next) => links[count % 4]!.teleport(somewhere(next)),
  'links turned round': ({ links }, count, next) =>
    links[count % 4]!.set('orientation', [next(), next(), next(), 3 * next()]),
  'anchors moved': ({ joints }, count, next) =>
    joints[count % 4]!.set('anchorPoint', somewhere(next)),
  'joints given other bodies': ({ joints, links, tower }, count) =>
    joints[count % 4]!.set('body2', [...tower, ...links][count % 7]),
  'masses changed': ({ links, tower }, count, next) =>
    [...links, ...tower][count % 7]!.set('mass', 10 ** (4 * next() - 2)),
  'inertias changed': ({ links }, count, next) => {
    const [x, y, z] = [next(), next(), next()].map((n) => 10 ** (2 * n - 2));
    links[count % 4]!.set('inertia', [x, 0, 0, 0, y, 0, 0, 0, z]);
  },
  'centres of mass moved': ({ links, tower }, count, next) =>
    [...links, ...tower][count % 7]!.set('centerOfMass', [next() - 0.5, next() / 5, next() / 5]),
  'bodies fixed and let go': ({ links, tower }, count) => {
    const body = [...links, ...tower][(3 * Math.floor(count / 2)) % 7]!;
    body.set('fixed', count % 2 === 0);
  },
  'bodies switched off and on': ({ links, tower }, count) => {
    const body = [...links, ...tower][(3 * Math.floor(count / 2)) % 7]!;
    body.set('enabled', count % 2 === 1);
  },
};

/** Other levels have their share of the random edits (`npm run fuzz -- --edits`). */
const LEVELS = ['game', 'standard'];

for (const [what, edit] of Object.entries(EDITS))
  for (const accuracy of LEVELS)
    fact(`at ${accuracy}, ${what}: nobody has motion that nobody gave`, async () => {
      below(await unexplained(accuracy, edit), UNEXPLAINED, 'm/s');
    });

for (const accuracy of LEVELS)
  fact(`at ${accuracy}, restored in the midst: nobody has motion that nobody gave`, async () => {
    let snapshot: Snapshot | undefined;
    const most = await unexplained(accuracy, ({ w, joints, links }, count, next) => {
      if (count === 3) snapshot = w.snapshot();
      if (count % 4 === 1) joints[count % 3]!.set('anchorPoint', somewhere(next));
      if (count % 4 === 2) links[count % 3]!.set('mass', 20 * next());
      if (count % 4 === 3) links[count % 3]!.set('position', somewhere(next));
      if (count % 5 === 4 && snapshot) w.restore(snapshot);
      if (count === 14) w.reset();
    });
    below(most, UNEXPLAINED, 'm/s');
  });

for (const accuracy of levelNames)
  fact(`at ${accuracy} what stands about a torn joint is not struck by its repair`, async () => {
    const w = await world({ ...WEIGHTLESS, accuracy });
    const [held, link] = [0, 1].map((x) =>
      addBody(w, { position: [x, 0, 0], geometry: [box(0.4)], mass: 10 }),
    ) as [Body, Body];
    addJoint(w, 'BallJoint', { body1: held, anchorPoint: [-0.5, 0, 0] });
    addJoint(w, 'BallJoint', { body1: link, body2: held, anchorPoint: [0.5, 0, 0] });
    // They touch what is drawn together: the one where it was, the others where it is put.
    const about = [
      [0, 0.3, 0],
      [1, 1.7, 0],
      [0.7, 2, 0],
    ].map((at) => addBody(w, { position: at, geometry: [box(0.2)] }));
    w.step();
    link.teleport([1, 2, 0]);
    for (let i = 0; i < 0.5 / w.timeStep; i++) {
      w.step();
      for (const body of [held, link, ...about]) {
        // It was 32 m/s at game to 508 m/s at reference.
        below(Math.hypot(...velocity(body)), 0.01, 'm/s');
        below(Math.hypot(...spin(body)), 0.01, 'rad/s');
      }
    }
  });
