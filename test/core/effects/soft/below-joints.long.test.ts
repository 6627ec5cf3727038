import type { World } from '../../../../physics-core/inside.js';
import {
  above,
  addBody,
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
  velocity,
  world,
  type Body,
  type Node,
  type Vec3,
} from '../../helpers.js';
import { swing } from '../water/helpers.js';
import { addRope, DOWN, G, LEVELS, line, place, places, tie } from './helpers.js';

const TILT = Math.PI / 6;
const along: Vec3 = [Math.sin(TILT), -Math.cos(TILT), 0];
const at = (far: number): Vec3 => along.map((x) => far * x) as Vec3;

/** A box of 1 kg on a rope of 1 m, another one on a joint below it, let go at 30 degrees; and all their energy, J. */
function hang(w: World, joint: string, heavy: number) {
  const sizes = [1, heavy];
  const boxes = sizes.map((mass, i) =>
    addBody(w, {
      mass,
      position: at(1.1 + 0.3 * i),
      orientation: [0, 0, 1, TILT],
      geometry: [box(0.1, 0.2, 0.1)],
    }),
  );
  const hinge = joint === 'SingleAxisHingeJoint' && { axis: [0, 0, 1] };
  addJoint(w, joint, { body1: boxes[0], body2: boxes[1], anchorPoint: at(1.25), ...hinge });
  const rope = addRope(w, line(20, 1, [0, 0, 0], along), { fixedIndex: [0], mass: 1e-3 });
  tie(w, rope, 20, { body: boxes[0], position: [0, 0.1, 0] });
  // Velocities are of the middle of a step.
  const energy = (before: readonly number[]): number =>
    boxes.reduce((all, body, i) => {
      const turns = Math.hypot(...(body.get('angularVelocity') as Vec3));
      const inertia = (0.1 ** 2 + 0.2 ** 2) / 12;
      const moves = Math.hypot(...velocity(body));
      const high = (height(body) + before[i]!) / 2;
      return all + sizes[i]! * ((inertia * turns ** 2 + moves ** 2) / 2 + G * high);
    }, 0);
  return { boxes, rope, energy, swings: G * (1.1 + 1.4 * heavy) * (1 - Math.cos(TILT)) };
}

const lengthOf = (rope: Node): number =>
  places(rope).reduce((sum, to, i, all) => sum + (i > 0 ? distance(to, all[i - 1]!) : 0), 0);

/** Most that it may lose in 4 s, of what it swings with: what is 100 kg below 1 kg damps that by its joint's own law. */
const LOSES: Record<string, Record<number, number>> = {
  game: { 100: 0.07, 10: 6e-3, 1: 1e-3, 0.01: 1e-3 },
  standard: { 100: 0.025, 10: 3e-4, 1: 3e-4, 0.01: 3e-4 },
  reference: { 100: 3e-4, 10: 3e-4, 1: 3e-4, 0.01: 3e-4 },
};

for (const [accuracy, masses] of Object.entries(LOSES))
  for (const [heavy, loses] of Object.entries(masses))
    for (const joint of ['BallJoint', 'SingleAxisHingeJoint'])
      fact(
        `${heavy} kg on a ${joint} below 1 kg on a rope swing and stay, at ${accuracy}`,
        async () => {
          const w = await world({ accuracy });
          const { boxes, rope, energy, swings } = hang(w, joint, Number(heavy));
          const first = energy(boxes.map(height));
          let widest = 0;
          const seconds = accuracy === 'reference' ? 1.5 : 4;
          for (let i = 0; i < seconds / w.timeStep; i++) {
            const before = boxes.map(height);
            w.step();
            const off = (energy(before) - first) / swings;
            above(off, -loses, `loses, step ${i}`);
            below(off, 5e-4, `gains, step ${i}`);
            below(lengthOf(rope), 1 + 2e-4, 'long');
            widest = Math.max(widest, -position(boxes[1]!)[0]);
          }
          above(widest, 0.9 * at(1.4)[0], 'wide');
        },
      );

for (const accuracy of ['game', 'standard'])
  for (const heavy of [100, 1, 0.01])
    fact(
      `ropes and joints find one velocity for ${heavy} kg below 1 kg, at ${accuracy}`,
      async () => {
        const w = await world({ accuracy });
        const { boxes, rope } = hang(w, 'BallJoint', heavy);
        const [body] = boxes;
        for (let i = 0; i < 1 / w.timeStep; i++) {
          w.step();
          const [, , z, angle] = body!.get('orientation') as number[];
          const turned = z! * angle!;
          const [x, y] = position(body!);
          // Both went there on their own.
          const tied: Vec3 = [x - 0.1 * Math.sin(turned), y + 0.1 * Math.cos(turned), 0];
          below(distance(place(rope, 20), tied), 1e-6, `step ${i}`);
        }
      },
    );

// ---- several bodies that joints hold together --------------------------------------------------------------------------

/** A bar of 50 kg on two rings of 0.1 kg, each on a rope of 1 m. */
function seat(w: World): { bar: Body; ropes: Node[] } {
  const bar = addBody(w, { mass: 50, position: [0, -1.1, 0], geometry: [box(1, 0.1, 0.1)] });
  const ropes = [-0.5, 0.5].map((x) => {
    const ring = addBody(w, { mass: 0.1, position: [x, -1.03, 0], geometry: [sphere(0.03)] });
    addJoint(w, 'BallJoint', { body1: bar, body2: ring, anchorPoint: [x, -1.05, 0] });
    const rope = addRope(w, line(10, 1, [x, 0, 0], DOWN), { fixedIndex: [0], mass: 1e-3 });
    tie(w, rope, 10, { body: ring, position: [0, 0.03, 0] });
    return rope;
  });
  return { bar, ropes };
}

for (const accuracy of ['game', 'standard', 'fine'])
  fact(
    `a heavy seat on light rings on two ropes swings with its own period, at ${accuracy}`,
    async () => {
      const w = await world({ accuracy });
      claim(w, 'mass-ratio');
      const { bar, ropes } = seat(w);
      bar.applyImpulse([10, 0, 0]);
      // To and fro, kept level by both: a point of 50 kg on 1.05 m.
      const { period } = swing(w, 8, () => position(bar)[0]);
      close(period / (2 * Math.PI * Math.sqrt(1.05 / G)), 1, 2e-3);
      for (const rope of ropes) close(lengthOf(rope), 1, 1e-4);
    },
  );

fact('a rope on what joints hold fast hangs as on a point of its own', async () => {
  const w = await world();
  const end: Vec3 = [0.6, -0.3, 0];
  const points = line(
    10,
    Math.hypot(...end),
    [0, 0, 0],
    end.map((x) => x / Math.hypot(...end)) as Vec3,
  );
  const [bound, free] = [0, 5].map((z) => {
    const rope = addRope(
      w,
      points.map(([x, y]): Vec3 => [x, y, z]),
      { mass: 0.02 },
    );
    const body = addBody(w, { mass: 20, position: [end[0], end[1], z], geometry: [sphere(0.1)] });
    tie(w, rope, 10, { body });
    return { rope, body };
  });
  const held = addBody(w, { position: [0, 0, 0], geometry: [sphere(0.05)] });
  for (const anchorPoint of [
    [0.1, 0.1, 0],
    [-0.1, 0.1, 0],
    [0, 0.1, 0.1],
  ])
    addJoint(w, 'BallJoint', { body1: held, anchorPoint });
  tie(w, bound!.rope, 0, { body: held });
  free!.rope.set('fixedIndex', [0]);
  for (let i = 0; i < 180; i++) {
    w.step();
    const [x, y] = position(free!.body);
    close(position(bound!.body), [x, y, 0], 1e-4, `step ${i}`);
    close(position(held), [0, 0, 0], 1e-5, `held, step ${i}`);
  }
});

fact('a joint that comes below a rope, and goes, is pulled from that step on', async () => {
  const w = await world();
  const rope = addRope(w, line(10, 1, [0, 0, 0], DOWN), { fixedIndex: [0], mass: 0.01 });
  const body = addBody(w, { mass: 1, position: [0, -1, 0], geometry: [sphere(0.05)] });
  tie(w, rope, 10, { body });
  w.advance(0.2);
  const heavy = addBody(w, { mass: 50, position: [0, -1.3, 0], geometry: [sphere(0.1)] });
  const joint = addJoint(w, 'BallJoint', { body1: body, body2: heavy, anchorPoint: [0, -1.1, 0] });
  w.advance(1);
  close(height(heavy), -1.3, 1e-3);
  joint.remove();
  w.advance(1);
  close(height(body), -1, 1e-3);
  below(height(heavy), -5);
});

// ---- what falls into its rope ------------------------------------------------------------------------------------------

/** A slack rope of 1 m and 10 g, up and down again, and 100 kg at its end: by itself, or on a joint below 1 kg. */
function fall(w: World, below: boolean): { bodies: Body[]; rope: Node } {
  const sizes = below ? [1, 100] : [100];
  const bodies = sizes.map((mass, i) =>
    addBody(w, { mass, position: [0.3, -0.1 - 0.3 * i, 0], geometry: [box(0.1, 0.2, 0.1)] }),
  );
  if (below)
    addJoint(w, 'BallJoint', {
      body1: bodies[0],
      body2: bodies[1],
      anchorPoint: [0.3, -0.25, 0],
    });
  const up = line(10, 0.5, [0, 0, 0], [0, 0.8, 0.6]);
  const down = line(10, 0.5, [0, 0.4, 0.3], [0.6, -0.8, 0]);
  const rope = addRope(w, [...up.slice(0, -1), ...down.slice(0, -1), [0.3, 0, 0]], {
    fixedIndex: [0],
    mass: 0.01,
  });
  tie(w, rope, 20, { body: bodies[0], position: [0, 0.1, 0] });
  return { bodies, rope };
}

for (const accuracy of LEVELS)
  for (const jointed of [false, true])
    fact(
      `100 kg that fall into a slack rope, ${jointed ? 'below 1 kg' : 'tied to it'}, are held, at ${accuracy}`,
      async () => {
        const w = await world({ accuracy });
        const { bodies, rope } = fall(w, jointed);
        const long = lengthOf(rope);
        const energy = (before: readonly number[]): number =>
          bodies.reduce((all, body, i) => {
            const high = (height(body) + before[i]!) / 2;
            return (
              all +
              (body.get('mass') as number) * (Math.hypot(...velocity(body)) ** 2 / 2 + G * high)
            );
          }, 0);
        const first = energy(bodies.map(height));
        for (let i = 0; i < 1.5 / w.timeStep; i++) {
          const before = bodies.map(height);
          w.step();
          below(energy(before) - first, 1, `energy, step ${i}`);
        }
        below(lengthOf(rope), long + 1e-3);
      },
    );
