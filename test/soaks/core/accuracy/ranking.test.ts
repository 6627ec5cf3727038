import assert from 'node:assert/strict';
import type { LevelName, World } from '../../../../physics-core/inside.js';
import {
  above,
  addBody,
  addJoint,
  below,
  box,
  close,
  distance,
  fact,
  position,
  random,
  sphere,
  world,
  type Body,
  type Vec3,
} from '../../../core/helpers.js';

// measureAccuracy on the paper's scenes: it ranks the levels as runs at those levels do, each from the scene's start.

const bodiesOf = (w: World): Body[] => [...w.bodies].filter(({ movable }) => movable);

/** Scene 1: eight balls on seven ball joints, the last twenty times as heavy. */
function pendulum(w: World): void {
  const d = Math.SQRT1_2;
  let last: Body | undefined;
  for (let i = 0; i < 8; i++) {
    const ball = addBody(w, {
      position: [i * d, -i * d, 0],
      fixed: i === 0,
      mass: i < 7 ? 0.1 : 2,
      useGlobalGravity: i === 7,
      geometry: [sphere(0.1)],
    });
    const anchorPoint = [(i - 1) * d, (1 - i) * d, 0];
    if (last) addJoint(w, 'BallJoint', { body1: last, body2: ball, anchorPoint });
    last = ball;
  }
}

/** Scene 2: a hull that a motor drives about a ball joint. */
function motor(w: World): void {
  const hull = {
    type: 'IndexedFaceSet',
    coord: [0.3, 0.3, 0.3, -0.3, -0.3, 0.3, -0.3, 0.3, -0.3, 0.3, -0.3, -0.3],
    coordIndex: [0, 2, 1, -1, 0, 1, 3, -1, 0, 3, 2, -1, 1, 2, 3, -1],
  };
  const pin = addBody(w, { fixed: true, geometry: [sphere(0.1)] });
  let last = pin;
  for (const i of [1, 2, 3, 4]) {
    const ball = addBody(w, { position: [0, -i, 0], mass: 0.5, geometry: [sphere(0.2)] });
    addJoint(w, 'BallJoint', { body1: last, body2: ball, anchorPoint: [0, -i, 0] });
    last = ball;
  }
  const driven = addBody(w, { position: [2, 0, 0], geometry: [hull] });
  addJoint(w, 'BallJoint', { body1: driven, body2: pin });
  addJoint(w, 'MotorJoint', { body1: driven, motor1Axis: [0, 0, 1], axis1Torque: 30 });
}

/** Scene 3: boxes fall into a room. */
function room(w: World): void {
  const wall = (at: number[], size: number[]) =>
    addBody(w, { fixed: true, position: at, geometry: [box(...size)] });
  wall([0, -0.5, 0], [6, 1, 6]);
  for (const s of [-2.5, 2.5]) {
    wall([s, 5, 0], [1, 12, 6]);
    wall([0, 5, s], [6, 12, 1]);
  }
  const next = random();
  for (let i = 0; i < 20; i++)
    addBody(w, {
      position: [(i % 3) - 1, 0.5 + Math.floor(i / 3), ((i >> 1) % 3) - 1],
      geometry: [box(0.5 + 0.4 * next())],
    });
}

/** Scene 4: hinged pieces on the ground, that bend. */
function chain(w: World): void {
  addBody(w, { fixed: true, position: [0, -0.5, 0], geometry: [box(100, 1, 100)] });
  let last: Body | undefined;
  for (let i = 0; i < 12; i++) {
    const piece = addBody(w, {
      position: [0.5 * i, 0.1, 0],
      mass: 0.5,
      geometry: [box(0.4, 0.2, 0.2)],
      linearVelocity: [0, 0, i % 2 ? 0.5 : -0.5],
    });
    const anchorPoint = [0.5 * i - 0.25, 0.1, 0];
    if (last)
      addJoint(w, 'SingleAxisHingeJoint', {
        body1: last,
        body2: piece,
        axis: [0, 1, 0],
        anchorPoint,
      });
    last = piece;
  }
}
type Scene = (w: World) => void;

/** Where all bodies are at every 1/60 s of a run at one level, from the scene's start. */
async function run(build: Scene, level: LevelName, seconds: number): Promise<Vec3[][]> {
  const w = await world({ accuracy: level });
  build(w);
  const moments: Vec3[][] = [];
  for (let i = 0; i < Math.round(seconds * 60); i++) {
    w.advance(1 / 60);
    moments.push(bodiesOf(w).map(position));
  }
  return moments;
}

/** The greatest distance of a body from where the finest run has it. */
const farthest = (moments: Vec3[][], finest: Vec3[][]): number =>
  Math.max(...moments.flatMap((at, i) => at.map((p, k) => distance(p, finest[i]![k]!))));

const SCENES: Record<string, { build: Scene; seconds: number; chaotic: boolean }> = {
  'a chain of eight balls': { build: pendulum, seconds: 1, chaotic: false },
  'a hull driven by a motor': { build: motor, seconds: 1, chaotic: false },
  'boxes that fall into a room': { build: room, seconds: 0.75, chaotic: false },
  // Pieces that rub on the ground stick at one moment or at the next.
  'a chain of hinges on the ground': { build: chain, seconds: 0.5, chaotic: true },
};

for (const [name, { build, seconds, chaotic }] of Object.entries(SCENES))
  fact(`measureAccuracy ranks the levels as runs at each of them do: ${name}`, async () => {
    const w = await world();
    build(w);
    const before = JSON.stringify(w.snapshot());
    const rows = await w.measureAccuracy({ seconds });
    assert.equal(JSON.stringify(w.snapshot()), before, 'the world itself stands as it stood');
    const { horizon, tolerance } = rows[0]!;
    assert.equal(rows[0]!.chaotic, chaotic);
    // What parts at the horizon is no longer compared.
    const until = chaotic ? horizon - 1 / 60 : seconds;
    const finest = await run(build, 'reference', until);
    for (const [i, { level, error }] of rows.entries()) {
      const off = farthest(await run(build, level, until), finest);
      close(error.position, off, 1e-6, `m at ${level}`);
      // A coarser level is no better, but for what counts as agreement.
      if (i > 0) below(error.position, rows[i - 1]!.error.position + tolerance, `m at ${level}`);
    }
    above(rows[0]!.error.position, rows[3]!.error.position, 'm, game against precise');
  });
