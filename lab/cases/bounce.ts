import type { Case, CaseBody } from '../case.js';
import { offPaths, roundingOf, type Path } from './paths.js';

const GRAVITY = 9.81;
/** From the floor to the ball, metres. */
const DROP = 2;
const RADIUS = 0.5;
const SECONDS = 3;

/** Why the error of small bounces does not shrink. */
const LAST_BOUNCES =
  "below X3D's minBounceSpeed, 0.1 m/s, nothing bounces: where the exact path still goes up 0.13 mm, the ball lies, 0.1 mm deep, at every level; what a look sees of that moment is chance";

const floor: CaseBody = {
  name: 'floor',
  fixed: true,
  shape: { type: 'Box', size: [20, 1, 20] },
  position: [0, -0.5, 0],
};

/** Flight after flight, each with the share `bounce` of the speed before; at last it lies. */
function path(bounce: number): Path {
  const fall = Math.sqrt((2 * DROP) / GRAVITY);
  return (time) => {
    if (time < fall) return [0, RADIUS + DROP - (GRAVITY * time ** 2) / 2, 0];
    let speed = GRAVITY * fall * bounce;
    let since = time - fall;
    while (speed > 1e-6 && since > (2 * speed) / GRAVITY) {
      since -= (2 * speed) / GRAVITY;
      speed *= bounce;
    }
    const height = speed > 1e-6 ? speed * since - (GRAVITY * since ** 2) / 2 : 0;
    return [0, RADIUS + height, 0];
  };
}

const drop = (bounce: number): Case => ({
  id: `bounce-${String(bounce).replace('.', '-')}`,
  name: `Bounce ${bounce}`,
  says: `A ball falls ${DROP} m onto a floor that returns ${bounce} of its speed; its path against flight after flight, each ${bounce}² as high as the one before.`,
  scene: {
    gravity: [0, -GRAVITY, 0],
    bodies: [
      floor,
      {
        name: 'ball',
        shape: { type: 'Sphere', radius: RADIUS },
        position: [0, RADIUS + DROP, 0],
      },
    ],
    contact: { bounce, friction: 0.3 },
  },
  seconds: SECONDS,
  unit: 'm',
  size: DROP,
  singlePrecision: roundingOf(RADIUS + DROP, SECONDS),
  watch: offPaths({ ball: path(bounce) }),
  ...(bounce === 0.5 && { exception: LAST_BOUNCES }),
});

export const cases: Case[] = [1, 0.8, 0.5, 0].map(drop);
