import { drivenPendulum, pivotAt, type DrivenPendulum } from '../../references/driven-pendulum.js';
import { add } from '../../physics-core/base/math.js';
import type { Case } from '../case.js';
import { frameOf } from './judging.js';
import { offPaths, roundingOf, type Path } from './paths.js';

/** Of the ball, metres. */
const RADIUS = 0.1;

/** Steps of the reference in 1/60 s; twice as many change no angle by more than 1e-9 rad. */
const PER_FRAME = 64;

type Words = Pick<Case, 'id' | 'name' | 'says' | 'seconds' | 'size' | 'behind'>;

interface Driven extends Words {
  driven: Omit<DrivenPendulum, 'moment'>;
}

/** A ball on a ball joint of a pivot that is moved to and fro or up and down. */
export function drivenCase({ driven: given, ...words }: Driven): Case {
  const driven = { ...given, moment: given.arm ** 2 + 0.4 * RADIUS ** 2 };
  const { arm, gravity } = driven;
  const angleAt = drivenPendulum(driven, PER_FRAME);
  const pivot: Path = (time) => {
    const way = pivotAt(driven, time);
    return driven.along === 'y' ? [0, way, 0] : [way, 0, 0];
  };
  const bob: Path = (time) => {
    const angle = angleAt(frameOf(time));
    return add(pivot(time), [arm * Math.sin(angle), -arm * Math.cos(angle), 0]);
  };
  return {
    ...words,
    scene: {
      gravity: [0, -gravity, 0],
      bodies: [
        {
          name: 'pivot',
          fixed: true,
          shape: { type: 'Box', size: [0.05, 0.05, 0.05] },
          position: pivot(0),
          path: pivot,
        },
        { name: 'bob', shape: { type: 'Sphere', radius: RADIUS }, position: bob(0) },
      ],
      joints: [{ type: 'BallJoint', body1: 'bob', body2: 'pivot', anchorPoint: [0, 0, 0] }],
    },
    unit: 'm',
    singlePrecision: roundingOf(1, words.seconds),
    watch: offPaths({ bob }),
  };
}
