import { sin } from '../../../physics-core/base/exact/index.js';
import type { World } from '../../../physics-core/inside.js';
import { stack } from '../../../references/structures.js';
import { addWalls } from '../../walls.js';
import type { StabilityCase } from '../case.js';
import {
  addBody,
  addFloor,
  addHinge,
  addJoint,
  atTheEnd,
  box,
  fastest,
  greatest,
  height,
  most,
  moved,
  nothingCollides,
  position,
  random,
  speed,
  sphere,
  type Body,
} from '../scene.js';

// What an author does to what runs.

const WORK = 'its author moves, makes and unmakes things';

/** Every sixtieth of a second one of these, to one body after the other. */
function storm(w: World, bodies: Body[]): (seconds: number) => void {
  const next = random(11);
  const edits: ((body: Body) => void)[] = [
    (body) => body.set('mass', 0.5 + 2 * next()),
    (body) => body.set('geometry', [box(0.3 + 0.3 * next())]),
    (body) => body.set('geometry', [sphere(0.2 + 0.1 * next())]),
    (body) => body.set('linearVelocity', [next() - 0.5, 2 * next(), next() - 0.5]),
    (body) => body.set('angularVelocity', [next(), next(), next()]),
    (body) => body.set('position', [4 * next() - 2, 1 + 2 * next(), 4 * next() - 2]),
    (body) => body.set('enabled', false),
    (body) => body.set('enabled', true),
    (body) => body.set('fixed', next() > 0.8),
    () => w.set('gravity', [next() - 0.5, -9.8 + next(), next() - 0.5]),
    () => w.set('accuracy', ['game', 'standard', 'fine'][Math.floor(3 * next())]!),
  ];
  return () =>
    edits[Math.floor(next() * edits.length)]!(bodies[Math.floor(next() * bodies.length)]!);
}

export const edits: StabilityCase[] = [
  {
    id: 'S22',
    says: 'a carried wall pushes a box out at its own speed',
    seconds: 3.5,
    criterion: { what: 'greatest speed', unit: 'm/s', most: 2.5 },
    promisedFrom: 'game',
    work: 'the wall is moved',
    scene(w) {
      addFloor(w);
      const wall = addBody(w, { fixed: true, position: [-2, 1, 0], geometry: [box(1, 2, 4)] });
      const stone = addBody(w, { position: [0, 0.5, 0], geometry: [box(1)] });
      let fast = 0;
      return {
        before: (seconds) => {
          if (seconds > 0.5) wall.set('position', [-2 + (seconds - 0.5), 1, 0]);
        },
        after: () => (fast = Math.max(fast, speed(stone))),
        // The wall ends at 1, so its face lies at 1.5.
        measured: () => (position(stone)[0] > 1.95 && position(stone)[0] < 2.3 ? fast : NaN),
      };
    },
  },
  {
    id: 'S22 press',
    says: 'a press that comes down on a box lets it out at a bounded speed',
    seconds: 3,
    criterion: { what: 'greatest speed', unit: 'm/s', most: 10 },
    promisedFrom: 'game',
    work: 'the press is moved',
    mayTell: ['sunk'],
    scene(w) {
      addFloor(w);
      const press = addBody(w, { fixed: true, position: [0, 2.5, 0], geometry: [box(4, 1, 4)] });
      const stone = addBody(w, { position: [0.3, 0.5, 0], geometry: [box(1)] });
      return greatest(() => speed(stone), {
        before: (seconds) => press.set('position', [0, Math.max(2.5 - seconds, 1), 0]),
      });
    },
  },
  {
    id: 'S24',
    says: 'gravity that flips throws a pile up with bounded speed',
    seconds: 7,
    criterion: { what: 'greatest speed', unit: 'm/s', most: 12 },
    promisedFrom: 'game',
    work: 'gravity changes',
    scene(w) {
      addFloor(w);
      addFloor(w, 11);
      const boxes = Array.from({ length: 9 }, (_, i) =>
        addBody(w, {
          position: [(i % 3) * 1.1, 0.5 + Math.floor(i / 3), 0],
          geometry: [box(1)],
        }),
      );
      return greatest(() => fastest(boxes), {
        before: (seconds) => w.set('gravity', [0, Math.floor(seconds) % 2 ? 9.8 : -9.8, 0]),
      });
    },
  },
  {
    id: 'S28',
    says: 'two hundred bodies added and removed sixty times leave the heap at its size',
    seconds: 1,
    finest: 'game',
    criterion: { what: 'growth of the heap', unit: 'bytes', most: 0 },
    promisedFrom: 'game',
    work: WORK,
    scene(w) {
      let [bodies, size]: [Body[], number] = [[], 0];
      return atTheEnd(() => w.stats.heapBytes - size, {
        before: () => {
          for (const body of bodies) body.remove();
          bodies = Array.from({ length: 200 }, (_, k) =>
            addBody(w, { position: [2 * (k % 16), 0, 2 * Math.floor(k / 16)] }),
          );
        },
        after: () => (size ||= w.stats.heapBytes),
      });
    },
  },
  {
    id: 'S29',
    says: 'a box taken out of a tower lets those above down, and nothing else moves',
    seconds: 4,
    criterion: { what: 'off their places in the end', unit: 'm', most: 0.02 },
    promisedFrom: 'game',
    world: { rest: 'auto' },
    work: WORK,
    scene(w) {
      addFloor(w);
      const bodies = stack(6).map((one) => addBody(w, one));
      return atTheEnd(
        () =>
          most(bodies.filter((_, i) => i !== 2).map((body, i) => Math.abs(height(body) - 0.5 - i))),
        {
          before: (_, frame) => {
            if (frame === 120) bodies[2]!.remove();
          },
        },
      );
    },
  },
  {
    id: 'S29 jointed',
    says: 'a link taken out of a chain lets the rest fall free',
    seconds: 2,
    criterion: { what: 'off the fall', unit: 'm', most: 1e-3 },
    promisedFrom: 'game',
    work: WORK,
    mayTell: ['no-body'],
    scene(w) {
      nothingCollides(w);
      const links: Body[] = [];
      for (let i = 0; i < 6; i++) {
        const link = addBody(w, {
          position: [0, -0.25 - 0.5 * i, 0],
          geometry: [box(0.05, 0.45, 0.05)],
        });
        addJoint(w, 'BallJoint', {
          body1: link,
          ...(i > 0 && { body2: links[i - 1] }),
          anchorPoint: [0, -0.5 * i, 0],
        });
        links.push(link);
      }
      // It hangs at rest: what is below falls as anything does, for a second.
      return atTheEnd(() => Math.abs(height(links[5]!) + 2.75 + 4.9), {
        before: (_, frame) => {
          if (frame === 60) links[2]!.remove();
        },
      });
    },
  },
  {
    id: 'S30',
    says: 'a box in a tower that grows and shrinks moves nobody faster than 1 m/s',
    seconds: 4,
    criterion: { what: 'greatest speed', unit: 'm/s', most: 1 },
    promisedFrom: 'game',
    work: WORK,
    scene(w) {
      addFloor(w);
      const bodies = stack(3).map((one) => addBody(w, one));
      return greatest(() => fastest(bodies), {
        before: (seconds) => {
          if (seconds > 0.5) bodies[1]!.set('geometry', [box(1, 1 + 0.02 * sin(20 * seconds), 1)]);
        },
      });
    },
  },
  {
    id: 'mass',
    says: 'a tower whose masses change while it stands keeps standing',
    load: { of: 'masses', ratio: 10_000 },
    seconds: 5,
    criterion: { what: 'farthest from its place', unit: 'm', most: 1e-3 },
    promisedFrom: 'game',
    work: WORK,
    scene(w) {
      addFloor(w);
      const bodies = stack(5).map((one) => addBody(w, { ...one, mass: 100 }));
      return greatest(moved(bodies), {
        before: (_, frame) => {
          if (frame % 30 === 0)
            for (const body of bodies) body.set('mass', frame % 60 ? 0.01 : 100);
        },
      });
    },
  },
  {
    id: 'torn',
    says: 'a link that is put a metre away is pulled back at a bounded speed',
    seconds: 4,
    criterion: { what: 'greatest speed', unit: 'm/s', most: 20 },
    promisedFrom: 'game',
    work: WORK,
    mayTell: ['joint-repair'],
    scene(w) {
      nothingCollides(w);
      const rods: Body[] = [];
      for (let i = 0; i < 5; i++) {
        const rod = addBody(w, {
          position: [0.5 * i + 0.25, 0, 0],
          geometry: [box(0.45, 0.05, 0.05)],
        });
        addHinge(w, {
          body1: rod,
          ...(i > 0 && { body2: rods[i - 1] }),
          axis: [0, 0, 1],
          anchorPoint: [0.5 * i, 0, 0],
        });
        rods.push(rod);
      }
      return greatest(() => fastest(rods), {
        before: (_, frame) => {
          if (frame % 60 === 30) {
            const [x, y] = position(rods[2]!);
            rods[2]!.teleport([x, y + 1, 0]);
          }
        },
      });
    },
  },
  {
    id: 'storm',
    says: 'a minute of edits at 60 Hz leaves forty bodies finite, in their room and slow',
    load: { of: 'edits', ratio: 3600 },
    seconds: 60,
    finest: 'game',
    // A fall of the room's 6 m ends at 11 m/s.
    criterion: { what: 'greatest speed', unit: 'm/s', most: 15 },
    promisedFrom: 'game',
    work: WORK,
    mayTell: ['initial-overlap', 'mass-ratio', 'sunk'],
    scene(w) {
      addFloor(w);
      addWalls(w, 3, 8);
      const bodies = Array.from({ length: 40 }, (_, i) =>
        addBody(w, {
          position: [(i % 5) - 2, 0.5 + 0.7 * Math.floor(i / 25), (Math.floor(i / 5) % 5) - 2],
          geometry: [box(0.5)],
        }),
      );
      return greatest(() => fastest(bodies), { before: storm(w, bodies) });
    },
  },
];
