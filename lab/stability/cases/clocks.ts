import type { World } from '../../../physics-core/inside.js';
import { stack } from '../../../references/structures.js';
import type { StabilityCase } from '../case.js';
import {
  addBody,
  addFloor,
  addJoint,
  atTheEnd,
  box,
  greatest,
  most,
  moved,
  nothingCollides,
  position,
  random,
  spin,
  type Body,
} from '../scene.js';

// Clocks of pages: slow, fast, jittering, stopped for a while; and steps that change their length.

/** A tower of ten, looked at while time passes in its own way. */
const tower = (
  words: Pick<StabilityCase, 'id' | 'says'> & Partial<StabilityCase>,
  passing: (w: World) => () => void,
): StabilityCase => ({
  seconds: 5,
  load: { of: 'boxes', ratio: 10 },
  criterion: { what: 'farthest from its place', unit: 'm', most: 1e-3 },
  promisedFrom: 'game',
  ...words,
  scene(w) {
    addFloor(w);
    const bodies = stack(10).map((one) => addBody(w, one));
    return greatest(moved(bodies), { pass: passing(w) });
  },
});

/** Frames of so many hertz, about a sixtieth of a second's worth in each turn. */
function ticking(w: World, hertz: () => number): () => void {
  let due = 0;
  return () => {
    due += 1 / 60;
    for (let frame = 1 / hertz(); due >= frame - 1e-9; frame = 1 / hertz()) {
      w.frame(frame);
      due -= frame;
    }
  };
}

const clock = (hertz: number): StabilityCase =>
  tower(
    {
      id: `${hertz} Hz`,
      says: `a tower of ten stands where frames come ${hertz} times a second`,
      // A frame of a fifth of a second gives away half of it.
      ...(hertz < 10 && { mayTell: ['lag'] }),
    },
    (w) => ticking(w, () => hertz),
  );

/** A rod on a hinge of the world, let go level. */
function pendulum(w: World): Body {
  nothingCollides(w);
  const rod = addBody(w, { position: [0.5, 0, 0], geometry: [box(1, 0.02, 0.02)] });
  addJoint(w, 'SingleAxisHingeJoint', { body1: rod, axis: [0, 0, 1] });
  return rod;
}

const million = {
  seconds: 0,
  steps: 1e6,
  finest: 'game',
  slow: true,
  load: { of: 'steps', ratio: 1e6 },
  promisedFrom: 'game',
  world: { gravity: [0, 0, 0] },
} as const;

export const clocks: StabilityCase[] = [
  ...[5, 24, 60, 144, 240].map(clock),
  tower(
    {
      id: 'jitter',
      says: 'a tower of ten stands where frames jitter between 5 and 240 Hz',
      mayTell: ['lag'],
    },
    (w) => {
      const next = random(3);
      return ticking(w, () => 5 * 48 ** next());
    },
  ),
  tower(
    {
      id: 'S11',
      says: 'a tower of ten stands after a tab was hidden for ten seconds',
      tells: ['lag'],
    },
    (w) => {
      let frames = 0;
      return () => w.frame(++frames % 60 ? 1 / 60 : 10);
    },
  ),
  tower(
    {
      id: 'S11 advance',
      says: 'a tower of ten stands through one advance of ten seconds',
      seconds: 0.1,
    },
    (w) => () => void w.advance(10),
  ),
  tower(
    {
      id: 'S31',
      says: 'a tower of ten stands while the level changes in every frame',
      finest: 'game',
    },
    (w) => {
      let frames = 0;
      return () => {
        w.set('accuracy', ['standard', 'fine'][++frames % 2]!);
        w.advance(1 / 60);
      };
    },
  ),
  tower(
    {
      id: 'S31 wide',
      says: 'a tower of ten stands while the step changes between 1/60 and 1/960 s',
      finest: 'game',
    },
    (w) => {
      let frames = 0;
      return () => {
        w.set('accuracy', ['game', 'reference'][++frames % 2]!);
        w.advance(1 / 60);
      };
    },
  ),
  {
    id: 'S31 swing',
    says: 'a pendulum gains no energy while the level changes in every frame',
    seconds: 20,
    criterion: { what: 'above where it was let go', unit: 'm', most: 0.01 },
    promisedFrom: 'game',
    finest: 'game',
    work: 'energy is judged by its height: steps change, and with them the moment of the velocity',
    scene(w) {
      const rod = pendulum(w);
      let frames = 0;
      return greatest(() => position(rod)[1], {
        pass: () => {
          w.set('accuracy', ['game', 'fine', 'standard'][++frames % 3]!);
          w.advance(1 / 60);
        },
      });
    },
  },
  {
    id: 'S27',
    says: 'a plate that spins keeps its rate and a unit quaternion for a million steps',
    ...million,
    criterion: { what: 'off its rate, or a unit quaternion', unit: '', most: 1e-6 },
    scene(w) {
      const plate = addBody(w, { geometry: [box(1, 0.2, 1)], angularVelocity: [0, 5, 0] });
      return atTheEnd(() => {
        const unit = Math.hypot(...plate.pose().q);
        return most([Math.abs(spin(plate)[1] / 5 - 1), Math.abs(unit - 1)]);
      });
    },
  },
  {
    id: 'S27 adrift',
    says: 'a ball adrift at a millimetre a second is where it ought to be after a million steps',
    ...million,
    // Each step rounds the place to single precision.
    criterion: { what: 'off its way, of its way', unit: '', most: 0.02 },
    scene(w) {
      const ball = addBody(w, { linearVelocity: [1e-3, 0, 0] });
      return atTheEnd(() => Math.abs(position(ball)[0] / (1e-3 * w.time) - 1));
    },
  },
  {
    id: 'S27 swing',
    says: 'a pendulum swings as high after a hundred thousand steps',
    seconds: 0,
    steps: 1e5,
    finest: 'standard',
    load: { of: 'steps', ratio: 1e5 },
    criterion: { what: 'below the height it was let go from', unit: 'm', most: 0.05 },
    promisedFrom: 'game',
    lowest: -1,
    scene(w) {
      const rod = pendulum(w);
      let highest = -Infinity;
      return {
        after: () => {
          // Of the last ten seconds.
          if (w.time > 1e5 * w.timeStep - 10) highest = Math.max(highest, position(rod)[1]);
        },
        measured: () => Math.abs(highest),
      };
    },
  },
];
