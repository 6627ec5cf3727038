import type { DominoRow } from '../../../references/domino-wave.js';
import type { CaseBody } from '../../case.js';
import type { Play, StabilityCase } from '../case.js';
import { addBody, addFloor, position, type Vec3 } from '../scene.js';
import { FLOOR } from '../told.js';

/** Everything rubs by a half, which is the default. */
export const ROW: DominoRow = {
  height: 0.24,
  thickness: 0.03,
  gap: 0.07,
  friction: 0.5,
  gravity: 9.8,
};
const COUNT = 100;
const PITCH = ROW.gap + ROW.thickness;

/** The first leans on nothing, and falls. */
const pieces: CaseBody[] = Array.from({ length: COUNT }, (_, i) => ({
  name: `${i}`,
  position: i === 0 ? [0.016, 0.121, 0] : [PITCH * i, ROW.height / 2, 0],
  ...(i === 0 && { orientation: [0, 0, 1, -0.14] }),
  shape: { type: 'Box', size: [ROW.thickness, ROW.height, 0.12] },
}));

/** A longer floor than others need. */
const FLOOR_AT: Vec3 = [10, -0.5, 0];

/** When each falls. */
function wave(placeOf: (i: number) => Vec3, now: () => number): Play {
  const fell = pieces.map(() => 0);
  const pace = (from: number, to: number) => (to - from) / (fell[to]! - fell[from]!);
  const all = () => fell.every((time) => time > 0);
  return {
    after: () =>
      fell.forEach((time, i) => {
        if (!time && placeOf(i)[0] > PITCH * i + 0.01) fell[i] = now();
      }),
    // Pieces per second: of the 60th to the 95th, against those before.
    measured: () => (all() ? Math.abs(pace(60, 95) / pace(30, 60) - 1) : Infinity),
    noted: () => ({ speed: all() ? PITCH * pace(30, 95) : NaN }),
  };
}

export const dominoes: StabilityCase = {
  id: 'dominoes',
  says: 'a hundred dominoes fall, one after the other, in an even wave',
  load: { of: 'bodies', ratio: COUNT },
  seconds: 9,
  finest: 'precise',
  criterion: { what: 'unevenness of the wave', unit: '', most: 0.1 },
  promisedFrom: 'game',
  scene(w) {
    addFloor(w, 0, { position: FLOOR_AT });
    const bodies = pieces.map(({ position, orientation, shape }) =>
      addBody(w, { position, ...(orientation && { orientation }), geometry: [shape] }),
    );
    return wave(
      (i) => position(bodies[i]!),
      () => w.time,
    );
  },
  told: () => ({
    scene: {
      gravity: [0, -ROW.gravity, 0],
      bodies: [{ ...FLOOR, position: FLOOR_AT }, ...pieces],
      contact: { bounce: 0, friction: ROW.friction },
    },
    play(running) {
      let steps = 0;
      const played = wave(
        (i) => running.position(`${i}`),
        () => steps * running.timeStep,
      );
      return {
        ...played,
        after() {
          steps++;
          played.after!();
        },
      };
    },
  }),
};
