import type { Case, CaseBody, Vec3 } from '../case.js';
import { offPathsOnFloor, roundingOf, type Path } from './paths.js';

const GRAVITY = 9.81;

/** Flat, so that it does not tip; its top is at height 0. */
const floor: CaseBody = {
  name: 'floor',
  fixed: true,
  shape: { type: 'Box', size: [40, 1, 40] },
  position: [0, -0.5, 0],
};

const HEIGHT = 0.2;
const block = (fields: Partial<CaseBody> = {}): CaseBody => ({
  name: 'block',
  shape: { type: 'Box', size: [1, HEIGHT, 1] },
  position: [0, HEIGHT / 2, 0],
  ...fields,
});

/** From rest along x. */
const speedingUp =
  (acceleration: number, z = 0): Path =>
  (time) => [(acceleration * time ** 2) / 2, HEIGHT / 2, z];

// ---- an incline ------------------------------------------------------------------------------------------------------

/** The floor lies flat and gravity leans instead. */
function incline(id: string, name: string, friction: number, degrees = 30, seconds = 1): Case {
  const angle = (degrees * Math.PI) / 180;
  const leaning: Vec3 = [GRAVITY * Math.sin(angle), -GRAVITY * Math.cos(angle), 0];
  const longer = seconds > 1 ? `, for ${seconds} s` : '';
  const slides = Math.tan(angle) > friction;
  const acceleration = slides ? GRAVITY * (Math.sin(angle) - friction * Math.cos(angle)) : 0;
  return {
    id,
    name,
    says: slides
      ? `A block on a slope of ${degrees}°, friction ${friction}; its place against g (sin θ - μ cos θ) t²/2.`
      : `A block on a slope of ${degrees}°, friction ${friction} > tan ${degrees}°${longer}; how far it moves.`,
    scene: {
      gravity: leaning,
      bodies: [floor, block()],
      contact: { bounce: 0, friction },
    },
    seconds,
    unit: 'm',
    size: 1,
    singlePrecision: roundingOf(1, seconds),
    watch: offPathsOnFloor({ block: speedingUp(acceleration) }),
  };
}

/** Shares of the push that just moves a block. */
const PUSHES = { held: 0.98, moved: 1.02 };
const FRICTION = 0.5;

function threshold(): Case {
  const seconds = 5;
  const limit = FRICTION * GRAVITY;
  const pushed = (name: keyof typeof PUSHES, z: number): CaseBody =>
    block({ name, position: [0, HEIGHT / 2, z], forces: [[PUSHES[name] * limit, 0, 0]] });
  const acceleration = (PUSHES.moved - 1) * limit;
  return {
    id: 'slide-threshold',
    name: 'Threshold of sliding',
    says: 'Two blocks, pushed with 98 % and 102 % of what friction 0.5 holds; the first stays, the second goes (2 % μ g) t²/2.',
    scene: {
      gravity: [0, -GRAVITY, 0],
      bodies: [floor, pushed('held', -2), pushed('moved', 2)],
      contact: { bounce: 0, friction: FRICTION },
    },
    seconds,
    unit: 'm',
    size: (acceleration * seconds ** 2) / 2,
    singlePrecision: roundingOf(2, seconds),
    watch: offPathsOnFloor({ held: speedingUp(0, -2), moved: speedingUp(acceleration, 2) }),
  };
}

// ---- thrown flat -----------------------------------------------------------------------------------------------------

function thrown(id: string, name: string, degrees: number): Case {
  const [speed, friction, seconds] = [3, 0.4, 1];
  const angle = (degrees * Math.PI) / 180;
  const brake = friction * GRAVITY;
  const path: Path = (time) => {
    const t = Math.min(time, speed / brake);
    const way = speed * t - (brake * t ** 2) / 2;
    return [way * Math.cos(angle), HEIGHT / 2, way * Math.sin(angle)];
  };
  return {
    id,
    name,
    says: `A block slides over a floor, ${degrees}° from the axis, at ${speed} m/s with friction ${friction}; its place against the straight line on which it stops after v²/(2 μ g).`,
    scene: {
      gravity: [0, -GRAVITY, 0],
      bodies: [
        floor,
        block({ linearVelocity: [speed * Math.cos(angle), 0, speed * Math.sin(angle)] }),
      ],
      contact: { bounce: 0, friction },
    },
    seconds,
    unit: 'm',
    size: speed ** 2 / (2 * brake),
    singlePrecision: roundingOf(1, seconds),
    watch: offPathsOnFloor({ block: path }),
  };
}

export const cases: Case[] = [
  incline('slope-block-slides', 'Block slides down an incline', 0.3),
  incline('slope-block-sticks', 'Block sticks to an incline', 0.6),
  incline('slope-block-stays', 'Block stays on an incline', 0.5, 25, 10),
  threshold(),
  thrown('slide-along-axis', 'Block thrown along an axis', 0),
  thrown('slide-across-axes', 'Block thrown across the axes', 45),
];
