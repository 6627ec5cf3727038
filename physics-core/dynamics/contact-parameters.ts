import type { Vec2, Vec3 } from '../fields/types.js';

/** Friction of a pair that no CollisionCollection speaks for. */
export const DEFAULT_FRICTION = 0.5;

/** What the solver is told about a touching pair, SI units. */
export interface ContactParameters {
  bounce: number;
  minBounceSpeed: number;
  /** Coulomb's coefficient along friction direction 1 and 2. */
  friction: Vec2;
  /** m/s along direction 1 and 2. */
  speed: Vec2;
  /** Sliding speed per tangential force, (m/s)/N. */
  slip: Vec2;
  /** Speed per normal force, (m/s)/N; 0 is hard. */
  softness: number;
  /** Share of an overlap repaired per 1/60 s; undefined: as the solver does it. */
  errorCorrection: number | undefined;
  /** Friction direction 1 where it is given. */
  direction: Vec3 | undefined;
}

/** Of a pair that no collection speaks for. */
export const PLAIN: ContactParameters = {
  bounce: 0,
  minBounceSpeed: 0,
  friction: [DEFAULT_FRICTION, DEFAULT_FRICTION],
  speed: [0, 0],
  slip: [0, 0],
  softness: 0,
  errorCorrection: undefined,
  direction: undefined,
};

/** Friction or motion differs by direction, so that directions must be given. */
export const isDirected = ({ friction, speed, slip }: ContactParameters): boolean =>
  friction[0] !== friction[1] || speed[0] !== 0 || speed[1] !== 0 || slip[0] !== 0 || slip[1] !== 0;

export const isSoft = ({ softness, errorCorrection }: ContactParameters): boolean =>
  softness > 0 || errorCorrection !== undefined;

/** It gives way to forces, or each direction of friction has its own limit: iterations of Bullet's solver see to that. */
export const isSpecial = ({ friction, slip, softness }: ContactParameters): boolean =>
  softness > 0 || slip[0] !== 0 || slip[1] !== 0 || friction[0] !== friction[1];

/** Nothing that Bullet would not do by itself. */
export const isPlain = (parameters: ContactParameters): boolean =>
  parameters.bounce === 0 &&
  parameters.friction.every((value) => value === DEFAULT_FRICTION) &&
  !isDirected(parameters) &&
  !isSoft(parameters);
