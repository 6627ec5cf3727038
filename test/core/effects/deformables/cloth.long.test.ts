import assert from 'node:assert';
import {
  addBody,
  above,
  below,
  close,
  fact,
  height,
  sphere,
  velocity,
  world,
  type Vec3,
} from '../../helpers.js';
import { deformables } from '../../../../physics-core/effects/deformables/effects.js';
import { steppingOf } from '../../thread/at-once.js';
import { addCloth, flat, G, LEVELS, place, places, tie } from './helpers.js';

/** Points of a sheet of `cells` x `cells` that lie on its edge. */
const edgeOf = (cells: number): number[] =>
  [...Array((cells + 1) ** 2).keys()].filter((i) => {
    const [x, y] = [i % (cells + 1), Math.floor(i / (cells + 1))];
    return x === 0 || y === 0 || x === cells || y === cells;
  });

// ---- threads --------------------------------------------------------------------------------------------------------------

for (const accuracy of LEVELS)
  fact(`a sheet of 30 x 30 points that hangs is as long as it is, at ${accuracy}`, async () => {
    const w = await world({ accuracy });
    const top = [...Array(30).keys()].map((i) => 29 * 30 + i);
    const cloth = addCloth(w, {
      size: [1, 1],
      subdivision: [29, 29],
      mass: 0.3,
      damping: 1,
      fixedIndex: top,
    });
    w.advance(4);
    for (let i = 0; i < 30; i++) close(place(cloth, i)[1], -0.5, 1e-6, `${i}`);
  });

fact('what stretches hangs as its stiffness says', async () => {
  const w = await world({ accuracy: 'standard' });
  const [cells, stiffness, mass] = [10, 40, 0.5];
  const top = [...Array(cells + 1).keys()].map((i) => cells * (cells + 1) + i);
  const cloth = addCloth(w, {
    size: [1, 1],
    subdivision: [cells, cells],
    mass,
    stretchStiffness: stiffness,
    shearStiffness: 0,
    damping: 3,
    fixedIndex: top,
  });
  w.advance(12);
  // Each row bears what hangs below it.
  let stretch = 0;
  for (let row = 1; row <= cells; row++) stretch += ((row - 0.5) / cells) * mass * G;
  close(place(cloth, 5)[1], -0.5 - stretch / cells / stiffness, 2e-4);
});

/** A net of squares, pulled out by a tenth all around, and how it swings: its slowest mode. */
for (const accuracy of LEVELS)
  fact(`a net under tension swings as its mode does, at ${accuracy}`, async () => {
    const w = await world({ accuracy, gravity: [0, -0.02, 0] });
    const [cells, stiffness, mass] = [20, 50, 0.4];
    const cloth = addCloth(w, {
      geometry: flat(cells, 1, 0),
      mass,
      stretchStiffness: stiffness,
      shearStiffness: 0,
      damping: 4,
    });
    places(cloth).forEach(([x, y, z], i) => {
      if (edgeOf(cells).includes(i)) tie(w, cloth, i, { position: [1.1 * x, y, 1.1 * z] });
    });
    w.advance(6);
    cloth.set('damping', 0);
    w.set('gravity', [0, 0, 0]);
    const mode = (): number =>
      places(cloth).reduce((sum, [, y], i) => {
        const [column, row] = [i % (cells + 1), Math.floor(i / (cells + 1))];
        return sum + y * Math.sin((Math.PI * column) / cells) * Math.sin((Math.PI * row) / cells);
      }, 0);
    const dt = w.timeStep;
    const crossings: number[] = [];
    let before = mode();
    let most = 0;
    let last = 0;
    const start = Math.abs(before);
    for (let t = dt; crossings.length < 21; t += dt) {
      w.step();
      const now = mode();
      if (Math.sign(now) !== Math.sign(before)) crossings.push(t - (dt * now) / (now - before));
      if (crossings.length >= 19) last = Math.max(last, Math.abs(now));
      most = Math.max(most, Math.abs(now));
      before = now;
    }
    const period = (crossings[20]! - crossings[0]!) / 10;
    const pull = (stiffness / cells) * 0.1;
    const square =
      ((8 * pull) / ((mass / cells ** 2) * (1.1 / cells))) * Math.sin(Math.PI / (2 * cells)) ** 2;
    close((period * Math.sqrt(square)) / (2 * Math.PI), 1, 1e-3, 'period');
    close(last / start, 1, 0.02, 'amplitude');
  });

// ---- bending --------------------------------------------------------------------------------------------------------------

/** How far the end of a clamped strip sinks under its own weight q, N/m, by the elastica: metres. */
function elastica(length: number, q: number, stiffness: number): number {
  const steps = 4000;
  const ds = length / steps;
  const end = (bend: number): { moment: number; sunk: number } => {
    let [angle, curvature, sunk] = [0, bend, 0];
    for (let i = 0; i < steps; i++) {
      const left = length - (i + 0.5) * ds;
      const middle = angle + (curvature * ds) / 2;
      const next = curvature - (q * left * Math.cos(middle) * ds) / stiffness;
      sunk += Math.sin(middle) * ds;
      angle += ((curvature + next) * ds) / 2;
      curvature = next;
    }
    return { moment: curvature, sunk };
  };
  let [low, high] = [0, (q * length ** 2) / stiffness];
  for (let n = 0; n < 60; n++) {
    const bend = (low + high) / 2;
    if (end(bend).moment > 0) high = bend;
    else low = bend;
  }
  return end((low + high) / 2).sunk;
}

for (const accuracy of ['game', 'standard', 'fine'])
  fact(`what stretches and is sheared into a line stays whole, at ${accuracy}`, async () => {
    const w = await world({ accuracy });
    // By two corners: warp and weft come to lie side by side, and answer what is there twice.
    const cloths = [300, 1000, 3000].map((stretchStiffness) =>
      addCloth(w, {
        size: [1, 1],
        subdivision: [20, 20],
        mass: 0.3,
        stretchStiffness,
        fixedIndex: [420, 440],
      }),
    );
    for (let second = 0; second < 3; second++) {
      w.advance(1);
      for (const cloth of cloths)
        for (const at of places(cloth)) below(Math.hypot(...at), 0.9, cloth.name);
    }
  });

fact('a clamped strip sinks as the elastica does', async () => {
  const w = await world({ accuracy: 'standard' });
  const [long, wide] = [18, 2];
  const length = 0.24;
  const cell = length / long;
  const strip = flat([long + 1, wide], [length + cell, 2 * cell], 0);
  const fixed = [...Array((long + 2) * (wide + 1)).keys()].filter((i) => i % (long + 2) < 2);
  const mass = 0.01;
  const stiffness = 1e-2;
  const cloth = addCloth(w, {
    geometry: strip,
    mass,
    bendStiffness: stiffness,
    shearStiffness: 1,
    damping: 4,
    fixedIndex: fixed,
  });
  w.advance(10);
  const weight = (mass / ((length + cell) * 2 * cell)) * G;
  const sunk = -place(cloth, long + 1 + (long + 2))[1];
  // Its first hinge stands for half a cell on either side of it.
  close(sunk / elastica(length + cell / 2, weight, stiffness), 1, 0.02);
});

// ---- what it lies on ------------------------------------------------------------------------------------------------------

const LIE: Record<string, { geometry: Record<string, unknown>; out: (at: Vec3) => number }> = {
  'a ball': {
    geometry: { type: 'Sphere', radius: 0.3 },
    out: ([x, y, z]) => Math.hypot(x, y, z) - 0.3,
  },
  'a box': {
    geometry: { type: 'Box', size: [0.4, 0.4, 0.4] },
    out: ([x, y, z]) => Math.max(Math.abs(x), Math.abs(y), Math.abs(z)) - 0.2,
  },
};

for (const [what, { geometry, out }] of Object.entries(LIE))
  fact(`a cloth on ${what} is nowhere inside it, does not creep, and comes to rest`, async () => {
    const w = await world({ accuracy: 'standard', rest: 'auto' });
    const sheet = flat(20, 1, 0.32);
    const cloth = addCloth(w, {
      geometry: sheet,
      thickness: 0.02,
      mass: 0.3,
      damping: 2,
      bendStiffness: 1e-5,
    });
    w.add('RigidBody', { fixed: true, geometry: [geometry] });
    w.advance(20);
    const before = places(cloth);
    const { index } = sheet;
    for (let f = 0; f < index.length; f += 3)
      for (let a = 0; a <= 4; a++)
        for (let b = 0; a + b <= 4; b++) {
          const at = [0, 1, 2].map((k) =>
            [a, b, 4 - a - b].reduce((sum, n, m) => sum + (n * before[index[f + m]!]![k]!) / 4, 0),
          ) as Vec3;
          above(out(at), 0);
        }
    w.advance(60);
    places(cloth).forEach((at, i) => close(at, before[i]!, 1e-3, `${i}`));
    const stopped = places(cloth);
    w.advance(1);
    assert.deepEqual(places(cloth), stopped);
  });

fact('a ball of 100 kg falls on a cloth of 1 kg, which holds it', async () => {
  const w = await world({ accuracy: 'standard' });
  addCloth(w, {
    geometry: flat(30, 2, 0),
    thickness: 0.02,
    mass: 1,
    fixedIndex: edgeOf(30),
    stretchStiffness: 20000,
  });
  const ball = addBody(w, { mass: 100, position: [0, 0.5, 0], geometry: [sphere(0.3)] });
  for (let i = 0; i < 20; i++) {
    w.advance(0.25);
    above(height(ball), -1);
    below(height(ball), 0.5);
  }
});

fact('a ball and a cloth that meet far from everything keep their momentum', async () => {
  const w = await world({ accuracy: 'standard', gravity: [0, 0, 0] });
  const cloth = addCloth(w, { geometry: flat(10, 1, 0), thickness: 0.02, mass: 1 });
  const ball = addBody(w, {
    mass: 2,
    position: [0.1, 0.5, 0],
    linearVelocity: [0, -2, 0],
    geometry: [sphere(0.2)],
  });
  w.step();
  const { masses } = steppingOf(w)
    .registry.find(deformables)!
    .of(cloth as never)!.material;
  for (let i = 0; i < 120; i++) {
    w.step();
    let sum = 2 * velocity(ball)[1];
    for (let n = 0; n < masses.count; n++) sum += masses.masses[n]! * masses.velocities[3 * n + 1]!;
    close(sum, -4, 4e-6, `${i}`);
  }
  above(velocity(ball)[1], -1.9);
});

fact('one that is asked to does not go through itself', async () => {
  const w = await world({ accuracy: 'standard' });
  w.add('RigidBody', {
    fixed: true,
    position: [0, -0.5, 0],
    geometry: [{ type: 'Box', size: [4, 1, 4] }],
  });
  const coord: number[] = [];
  const index: number[] = [];
  for (let j = 0; j <= 16; j++)
    for (let i = 0; i <= 4; i++) coord.push(0.05 * i, 0.05 * j + 0.02, 0.002 * Math.cos(1.7 * j));
  for (let j = 0; j < 16; j++)
    for (let i = 0; i < 4; i++) {
      const a = 5 * j + i;
      index.push(a, a + 1, a + 6, a, a + 6, a + 5);
    }
  const cloth = addCloth(w, {
    geometry: { type: 'IndexedTriangleSet', coord, index },
    thickness: 0.01,
    mass: 0.1,
    damping: 1,
    selfCollision: true,
  });
  w.advance(4);
  const all = places(cloth);
  for (let i = 0; i < all.length; i++)
    for (let j = 0; j < i; j++)
      above(Math.hypot(...[0, 1, 2].map((k) => all[i]![k]! - all[j]![k]!)), 0.008, `${i} ${j}`);
});
