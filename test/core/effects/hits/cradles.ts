import { quaternionOf, rotate } from '../../../../physics-core/base/math.js';
import type { World } from '../../../../physics-core/inside.js';
import {
  addBody,
  addJoint,
  position,
  spin,
  velocity,
  world,
  type Body,
  type Node,
} from '../../helpers.js';

export interface Cradle {
  w: World;
  balls: Body[];
  collection: Node;
}

interface Wanted {
  count?: number;
  /** Metres between the balls. */
  gap?: number;
  /** How many are raised, and how far, radians. */
  raised?: number;
  angle?: number;
  accuracy?: 'standard' | 'fine' | 'precise';
  fields?: Record<string, unknown>;
}

/**
 * The nodes of a kinetic pendulum as found on the web: balls of 0.5 m on thin rods of 4 m, which hang on hinges at their
 * upper ends; the centre of mass lies in the middle of the rod.
 */
export async function cradle(wanted: Wanted = {}): Promise<Cradle> {
  const { count = 5, gap = 0, raised = 1, angle = Math.PI / 2, accuracy, fields } = wanted;
  const w = await world(accuracy && { accuracy });
  const balls = Array.from({ length: count }, (_, i) =>
    pendulum(w, i * (1 + gap), i < raised ? angle : 0),
  );
  const collection = w.add('CollisionCollection', {
    collidables: '*',
    minBounceSpeed: 0,
    ...fields,
  });
  return { w, balls, collection };
}

function pendulum(w: World, x: number, angle: number): Body {
  const orientation = [0, 0, -1, angle] as const;
  const [dx, dy] = rotate(quaternionOf(orientation), [0, -2, 0]);
  const post = addBody(w, {
    fixed: true,
    position: [x, 2, 0],
    geometry: [w.add('CollidableShape', { shape: [{ type: 'Sphere', radius: 0.15 }] })],
  });
  const ball = w.add('CollidableShape', {
    translation: [0, -2, 0],
    shape: [{ type: 'Sphere', radius: 0.5 }],
  });
  const body = addBody(w, {
    mass: 0.01,
    position: [x + dx, 2 + dy, 0],
    orientation,
    geometry: [
      w.add('CollidableShape', { shape: [{ type: 'Cylinder', height: 4, radius: 0.03 }] }),
      w.add('CollidableOffset', { collidable: ball }),
    ],
  });
  addJoint(w, 'SingleAxisHingeJoint', {
    body1: post,
    body2: body,
    axis: [0, 0, 1],
    anchorPoint: [x, 2, 0],
  });
  return body;
}

export const turning = (ball: Body): number => spin(ball)[2];

/** Of all balls together, J. */
export const energyOf = (balls: Body[]): number =>
  balls.reduce((sum, ball) => {
    const { mass, moments } = ball.mass;
    const speed = Math.hypot(...velocity(ball));
    const turn = Math.max(...moments) * turning(ball) ** 2;
    return sum + mass * 9.8 * position(ball)[1] + (mass * speed ** 2 + turn) / 2;
  }, 0);

/** Runs to the first hit; the fastest that the first ball was. */
export function firstHit({ w, balls }: Cradle): number {
  let hit = 0;
  while (turning(balls[0]!) >= 0.8 * hit) {
    hit = Math.max(hit, turning(balls[0]!));
    w.step();
  }
  return hit;
}

/** For each half swing after the first hit: the fastest that the ball at the far end was, as a share of `hit`. */
export function sharesOf({ w, balls }: Cradle, hit: number, swings: number): number[] {
  // The way down to the first hit was half of a half swing.
  const steps = Math.round((2 * w.time) / w.timeStep);
  return Array.from({ length: swings }, (_, swing) => {
    const far = swing % 2 ? balls[0]! : balls.at(-1)!;
    let fastest = Math.abs(turning(far));
    for (let i = 0; i < steps; i++) {
      w.step();
      fastest = Math.max(fastest, Math.abs(turning(far)));
    }
    return fastest / hit;
  });
}
