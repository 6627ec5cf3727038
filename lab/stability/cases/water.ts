// What pages have no words for comes with it.
import '../../../physics-core/index.js';
import type { World } from '../../../physics-core/inside.js';
import type { StabilityCase } from '../case.js';
import {
  addBody,
  addJoint,
  atTheEnd,
  box,
  greatest,
  height,
  most,
  nothingCollides,
  sphere,
  speed,
  velocity,
  widest,
  type Fields,
  type Joint,
} from '../scene.js';

/** Its surface is at y = 0. */
const addSea = (w: World, fields: Fields = {}): void =>
  void w.add('WaterVolume', { size: [200, 60, 200], position: [0, -30, 0], ...fields });

const LIFTS = 'water lifts what is lighter';

/** √(ρ g A / m) of a raft of 2 × 1 × 2 m that is half as dense as water, 1/s. */
const HEAVE = Math.sqrt(2 * 9.8);
const AMPLITUDE = 0.05;

const heave: StabilityCase = {
  id: 'heave',
  says: 'a raft heaves for a minute without drag, as far as it did at first',
  load: { of: 'seconds', ratio: 60 },
  seconds: 60,
  criterion: { what: 'amplitude lost or gained, of itself', unit: '', most: 1e-3 },
  promisedFrom: 'game',
  work: LIFTS,
  scene(w) {
    addSea(w, { dragCoefficient: 0, liftCoefficient: 0, damping: 0 });
    const raft = addBody(w, {
      mass: 2000,
      position: [0, AMPLITUDE, 0],
      geometry: [box(2, 1, 2)],
    });
    return atTheEnd(() => {
      const swing = Math.hypot(height(raft), velocity(raft)[1] / HEAVE);
      return Math.abs(swing / AMPLITUDE - 1);
    });
  },
};

/** kg/m³: the lightest is one thousandth of water, the heaviest gold. */
const DENSITIES = [1, 5, 20, 100, 400, 700, 950, 1050, 3000, 19300];

const densities: StabilityCase = {
  id: 'densities',
  says: 'balls from a thousandth of the water’s density to gold fall in: those that are lighter float, none is flung',
  load: { of: 'densities', ratio: 19300 },
  seconds: 20,
  criterion: { what: 'greatest speed of those that float, in the end, m/s', unit: '', most: 0.01 },
  promisedFrom: 'game',
  work: LIFTS,
  scene(w) {
    addSea(w);
    const radius = 0.2;
    const balls = DENSITIES.map((density, i) =>
      addBody(w, {
        mass: (density * 4 * Math.PI * radius ** 3) / 3,
        position: [3 * i - 15, 2, 0],
        geometry: [sphere(radius)],
      }),
    );
    const floating = balls.filter((_, i) => DENSITIES[i]! < 1000);
    const above = (): boolean =>
      floating.every((ball) => Math.abs(height(ball)) < radius) &&
      balls.every((ball) => floating.includes(ball) || height(ball) < -5);
    return atTheEnd(() => (above() ? most(floating.map(speed)) : Infinity));
  },
};

const buoys: StabilityCase = {
  id: 'buoys',
  says: 'light buoys hold heavy chains up in a current, and no joint gapes',
  load: { of: 'masses', ratio: 100 },
  seconds: 10,
  criterion: { what: 'widest gap, of a link', unit: '', most: 0.01 },
  promisedFrom: 'game',
  mayTell: ['mass-ratio'],
  work: LIFTS,
  scene(w) {
    addSea(w, { flow: [1, 0, 0.5] });
    nothingCollides(w);
    const joints: Joint[] = [];
    for (let k = 0; k < 3; k++) {
      let last: unknown;
      for (let i = 0; i < 6; i++) {
        const top = i === 5;
        const y = -10 + 0.5 * i;
        const link = addBody(w, {
          mass: top ? 5 : 50,
          position: [5 * k, y + 0.25, 0],
          geometry: [top ? sphere(0.5) : box(0.1, 0.45, 0.1)],
        });
        joints.push(
          addJoint(w, 'BallJoint', {
            body1: link,
            ...(last !== undefined && { body2: last }),
            anchorPoint: [5 * k, y, 0],
          }),
        );
        last = link;
      }
    }
    return greatest(() => widest(joints) / 0.5);
  },
};

const raft: StabilityCase = {
  id: 'raft',
  says: 'a raft under twelve crates floats level, and keeps them',
  load: { of: 'bodies', ratio: 12 },
  seconds: 20,
  criterion: { what: 'how far a crate has sunk or slid off, m', unit: 'm', most: 0.05 },
  promisedFrom: 'game',
  work: LIFTS,
  scene(w) {
    addSea(w);
    addBody(w, { mass: 4000, position: [0, 0, 0], geometry: [box(4, 1, 4)] });
    const crates = Array.from({ length: 12 }, (_, i) => {
      const layer = Math.floor(i / 4);
      return addBody(w, {
        mass: 60,
        position: [(i % 2) - 0.5, 0.8 + 0.6 * layer, (Math.floor(i / 2) % 2) - 0.5],
        geometry: [box(0.6)],
      });
    });
    // With them it weighs 4720 kg on 16 m²; it was put down in the water by half.
    const sinks = 4720 / 16_000 - 0.5;
    const right = crates.map((crate) => height(crate) - sinks);
    return atTheEnd(() => most(crates.map((crate, i) => Math.abs(height(crate) - right[i]!))));
  },
};

export const waters: readonly StabilityCase[] = [heave, densities, buoys, raft];
