import { cos, sin } from '../../../physics-core/base/exact/index.js';
import { axesOf, kineticEnergy } from '../../../references/kinetic-energy.js';
import type { StabilityCase } from '../case.js';
import { addBody, addFloor, addHinge, box, greatest, position, sphere, spin } from '../scene.js';

// What is fast: bullets, blades, needles.

const bullet = (id: string, says: string, geometry: object): StabilityCase => ({
  id,
  says,
  load: { of: 'metres in a second', ratio: 300 },
  seconds: 0.1,
  criterion: { what: 'past the middle of the wall', unit: 'm', most: 0 },
  promisedFrom: 'game',
  world: { gravity: [0, 0, 0] },
  scene(w) {
    addBody(w, { fixed: true, position: [10, 0, 0], geometry: [box(0.02, 4, 4)] });
    const shot = addBody(w, { mass: 0.01, linearVelocity: [300, 0, 0], geometry: [geometry] });
    return greatest(() => position(shot)[0] - 10);
  },
});

const blade = (
  id: string,
  rate: number,
  promisedFrom: StabilityCase['promisedFrom'],
): StabilityCase => ({
  id,
  says: `a rod of 4 m that spins at ${rate} rad/s hits a thin post`,
  load: { of: 'radians in a second', ratio: rate },
  seconds: 20 / rate,
  criterion: { what: 'past the post', unit: 'rad', most: 0.05 },
  promisedFrom,
  world: { gravity: [0, 0, 0] },
  scene(w) {
    // The post stands 0.51 rad on, 1.9 m out.
    const at = [1.9 * cos(0.51), -1.9 * sin(0.51)];
    addBody(w, {
      fixed: true,
      position: [at[0], 0, at[1]],
      geometry: [{ type: 'Cylinder', radius: 0.02, height: 2 }],
    });
    const rod = addBody(w, { geometry: [box(4, 0.05, 0.05)], angularVelocity: [0, rate, 0] });
    addHinge(w, { body1: rod, axis: [0, 1, 0] });
    let turned = 0;
    return greatest(() => (turned += spin(rod)[1] * w.timeStep) - 0.51);
  },
});

export const speeds: StabilityCase[] = [
  bullet('S9 ball', 'a ball of 2 cm at 300 m/s never passes a wall of 2 cm', sphere(0.01)),
  bullet('S9 box', 'a box of 2 cm at 300 m/s never passes a wall of 2 cm', box(0.02)),
  bullet('S9 arrow', 'an arrow at 300 m/s never passes a wall of 2 cm', box(0.1, 0.01, 0.01)),
  // Steps are split while the post lies within reach of its ends.
  blade('S10', 40, 'game'),
  blade('S10 slow', 8, 'game'),
  {
    id: 'S15',
    says: 'a needle of 10 m that strikes a floor does not spin up',
    load: { of: 'sides', ratio: 10_000 },
    seconds: 5,
    criterion: { what: 'greatest spin', unit: 'rad/s', most: 200 },
    promisedFrom: 'game',
    mayTell: ['initial-overlap'],
    work: 'it begins in the floor, which pushes it out',
    scene(w) {
      addFloor(w);
      const needle = addBody(w, {
        position: [0, 1, 0],
        orientation: [0, 0, 1, 0.3],
        angularVelocity: [3, 2, 1],
        geometry: [box(10, 0.001, 0.001)],
      });
      return greatest(() => Math.hypot(...spin(needle)));
    },
  },
  {
    id: 'S15 pancake',
    says: 'a plate of 10 m and 1 mm that falls obliquely does not spin up',
    load: { of: 'sides', ratio: 10_000 },
    seconds: 5,
    criterion: { what: 'greatest spin', unit: 'rad/s', most: 20 },
    promisedFrom: 'game',
    scene(w) {
      addFloor(w);
      const plate = addBody(w, {
        position: [0, 3, 0],
        orientation: [0, 0, 1, 0.3],
        geometry: [box(10, 0.001, 10)],
      });
      return greatest(() => Math.hypot(...spin(plate)));
    },
  },
  {
    id: 'top',
    says: 'a plate that spins about its middle axis turns over and keeps its energy',
    seconds: 20,
    criterion: { what: 'energy lost or gained', unit: '', most: 0.01 },
    promisedFrom: 'game',
    world: { gravity: [0, 0, 0] },
    scene(w) {
      const plate = addBody(w, {
        geometry: [box(1, 0.2, 2)],
        angularVelocity: [6, 0.01, 0.01],
      });
      const energy = () => kineticEnergy(plate, [0, 0, 0], spin(plate), axesOf(plate));
      const start = energy();
      return greatest(() => Math.abs(energy() / start - 1));
    },
  },
];
