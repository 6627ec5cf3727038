import { describe } from 'node:test';
import type { LevelName } from '../../../../../physics-core/inside.js';
import { add, conjugate, dot, rotate } from '../../../../../physics-core/base/math.js';
import {
  addBody,
  addJoint,
  below,
  box,
  fact,
  position,
  sphere,
  world,
  type Body,
  type Vec3,
} from '../../../../core/helpers.js';

const G = 9.8;
const LEVELS: readonly LevelName[] = ['game', 'standard', 'fine', 'precise', 'reference'];

/** Metres from joint to joint, and mass of a link, kg. */
const LINK = 0.2;
const MASS = 0.1;

type Kind = 'BallJoint' | 'SingleAxisHingeJoint';

/** Joules of motion and height. Velocities are those of the middle of the last step, heights those of its end. */
function energy(links: readonly Body[], dt: number): number {
  let sum = 0;
  for (const body of links) {
    const { linear: v, angular } = body.velocityAtOrigin();
    const turning = rotate(conjugate(body.pose().q), angular);
    const { mass, moments } = body.mass;
    sum += (mass * dot(v, v)) / 2 + mass * G * (position(body)[1] - (v[1] * dt) / 2);
    for (let i = 0; i < 3; i++) sum += (moments[i]! * turning[i]! ** 2) / 2;
  }
  return sum;
}

/** A closed polygon of links about the origin, or with `corners` along these points; the world holds one link's middle. */
async function ring(accuracy: LevelName, count: number, kind: Kind, geometry: object) {
  const w = await world({ accuracy, gravity: [0, -G, 0] });
  w.add('CollisionCollection', { collidables: '*', enabled: false });
  const [apothem, half] = [LINK / 2 / Math.tan(Math.PI / count), Math.PI / count];
  const on = (r: number, angle: number): Vec3 => [r * Math.cos(angle), r * Math.sin(angle), 0];
  const links = Array.from({ length: count }, (_, i) => {
    const angle = (2 * i + 1) * half;
    return addBody(w, {
      position: on(apothem, angle),
      orientation: [0, 0, 1, angle + Math.PI / 2],
      mass: MASS,
      geometry: [geometry],
    });
  });
  const axis = kind === 'BallJoint' ? {} : { axis: [0, 0, 1] };
  links.forEach((body1, i) =>
    addJoint(w, kind, {
      body1,
      body2: links[(i + 1) % count],
      anchorPoint: on(apothem / Math.cos(half), (2 * i + 2) * half),
      ...axis,
    }),
  );
  const held = links[Math.floor(count / 4)]!;
  addJoint(w, kind, { body1: held, anchorPoint: position(held), ...axis });
  return { w, links, fall: count * MASS * G * 2 * apothem };
}

/** The greatest gain of energy in a run, as a share of what the ring has to fall by. */
async function gain(
  made: Promise<{ w: Awaited<ReturnType<typeof world>>; links: Body[]; fall: number }>,
  seconds: number,
): Promise<number> {
  const { w, links, fall } = await made;
  w.step(0);
  const start = energy(links, 0);
  let most = -Infinity;
  for (let i = 0; i < seconds / w.timeStep - 0.5; i++) {
    w.step();
    most = Math.max(most, energy(links, w.timeStep) - start);
  }
  w.destroy();
  return most / fall;
}

/** A chain of links along a zigzag, whose last link is tied to its first. */
async function tied(accuracy: LevelName) {
  const w = await world({ accuracy, gravity: [0, -G, 0] });
  w.add('CollisionCollection', { collidables: '*', enabled: false });
  const at = (i: number): Vec3 => [i < 6 ? i * LINK : (11 - i) * LINK, i < 6 ? 0 : LINK, 0];
  const links = Array.from({ length: 12 }, (_, i) =>
    addBody(w, { position: at(i), mass: MASS, geometry: [sphere(0.05)] }),
  );
  links.forEach((body1, i) => {
    const other = (i + 1) % 12;
    const middle = add(at(i), at(other)).map((x) => x / 2);
    addJoint(w, 'BallJoint', { body1, body2: links[other], anchorPoint: middle });
  });
  addJoint(w, 'BallJoint', { body1: links[0], anchorPoint: at(0) });
  return { w, links, fall: 12 * MASS * G * 6 * LINK };
}

describe('rings and loops', () => {
  for (const kind of ['BallJoint', 'SingleAxisHingeJoint'] as const)
    fact(`a ring of 20 links on ${kind}s gains no energy, at any level`, async () => {
      for (const accuracy of LEVELS)
        for (const geometry of [sphere(0.05), box(0.18, 0.05, 0.05)])
          below(await gain(ring(accuracy, 20, kind, geometry), 4), 0.01, `at ${accuracy}`);
    });

  fact('a ring of 200 links gains no energy, and does not fall apart', async () => {
    const made = ring('game', 200, 'SingleAxisHingeJoint', box(0.18, 0.05, 0.05));
    below(await gain(made, 5), 0.01);
  });

  fact('a chain tied to itself gains no energy, at any level', async () => {
    for (const accuracy of LEVELS) below(await gain(tied(accuracy), 4), 0.01, `at ${accuracy}`);
  });

  fact('a four-bar linkage gains no energy, at any level', async () => {
    for (const accuracy of LEVELS)
      below(await gain(ring(accuracy, 4, 'SingleAxisHingeJoint', box(0.18, 0.05, 0.05)), 6), 0.01);
  });
});
