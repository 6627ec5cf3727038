import type { CaseBody, CaseScene, Shape } from '../case.js';
import type { Running } from '../engines/engine.js';
import { gapsIn } from '../run/gap.js';
import type { Play } from './case.js';
import { distance, greatest, most, type Fields } from './scene.js';

/** A case in words that other engines have, too. */
export interface Told {
  scene: CaseScene;
  play(running: Running): Omit<Play, 'before' | 'pass'>;
}

const SHAPES = ['Box', 'Sphere', 'Cylinder'];
export const FLOOR: CaseBody = {
  name: 'floor',
  fixed: true,
  position: [0, -0.5, 0],
  shape: { type: 'Box', size: [60, 1, 60] },
};

/** Bodies of one shape each on a floor, and how far the one that moved most is from its place. */
export function toldStanding(pieces: readonly Fields[]): Told | undefined {
  const bodies = pieces.map(({ geometry, ...fields }, i): CaseBody => {
    const [shape] = geometry as [Shape];
    return { ...fields, name: `${i}`, shape };
  });
  if (bodies.some(({ shape }) => !SHAPES.includes(shape!.type))) return undefined;
  return {
    scene: {
      gravity: [0, -9.8, 0],
      bodies: [FLOOR, ...bodies],
      contact: { bounce: 0, friction: 0.5 },
    },
    play: (running) =>
      greatest(() =>
        most(bodies.map(({ name, position }) => distance(running.position(name), position!))),
      ),
  };
}

/** Rods let go level, each on a ball joint of the one before, and the widest gap of a link. */
export function toldChain(masses: readonly number[], link: number): Told {
  const scene: CaseScene = {
    gravity: [0, -9.8, 0],
    bodies: masses.map((mass, i) => ({
      name: `${i}`,
      mass,
      position: [(i + 0.5) * link, 0, 0],
      shape: { type: 'Box', size: [0.9 * link, 0.1 * link, 0.1 * link] },
    })),
    joints: masses.map((_, i) => ({
      type: 'BallJoint',
      body1: `${i}`,
      ...(i > 0 && { body2: `${i - 1}` }),
      anchorPoint: [i * link, 0, 0],
    })),
  };
  const gaps = gapsIn(scene);
  return { scene, play: (running) => greatest(() => most(gaps(running)) / link) };
}
