import type { Vec2, Vec3 } from '../fields/types.js';
import { DEFAULT_FRICTION } from '../world/pairs.js';
import type { PhysicsNode } from '../nodes/node.js';

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

/** Both spellings stand in real files: schema and examples print hyphens, the 4.0 prose underscores. */
const normal = (token: string): string => token.toUpperCase().replace(/[-_](?=[12]$)/, '_');

const TOKENS = new Set([
  'BOUNCE',
  'USER_FRICTION',
  'FRICTION_COEFFICIENT_2',
  'ERROR_REDUCTION',
  'CONSTANT_FORCE',
  'SPEED_1',
  'SPEED_2',
  'SLIP_1',
  'SLIP_2',
]);

/** The parameters of a CollisionCollection or a Contact, which name one field differently. */
export function contactParameters(
  node: PhysicsNode,
  slipField: 'slipFactors' | 'slipCoefficients',
): ContactParameters {
  const tokens = new Set(node.asked<string[]>('appliedParameters').map(normal));
  const two = (field: string, first: string, second: string, least: number): Vec2 => {
    const [x, y] = node.asked<Vec2>(field);
    return [
      tokens.has(first) ? Math.max(x, least) : 0,
      tokens.has(second) ? Math.max(y, least) : 0,
    ];
  };
  const soft = tokens.has('CONSTANT_FORCE');
  const global = soft ? node.world.settings.asked<number>('errorCorrection') : undefined;
  return {
    bounce: tokens.has('BOUNCE') ? node.asked<number>('bounce') : 0,
    minBounceSpeed: node.asked<number>('minBounceSpeed'),
    friction: alongBoth(frictionOf(node), tokens.has('FRICTION_COEFFICIENT_2')),
    speed: two('surfaceSpeed', 'SPEED_1', 'SPEED_2', -Infinity),
    slip: two(slipField, 'SLIP_1', 'SLIP_2', 0),
    softness: soft ? node.asked<number>('softnessConstantForceMix') : 0,
    errorCorrection: tokens.has('ERROR_REDUCTION')
      ? node.asked<number>('softnessErrorCorrection')
      : global,
    direction: undefined,
  };
}

/** Without the token the first coefficient acts in both directions. */
const alongBoth = ([x, y]: Vec2, both: boolean): Vec2 => [x, both ? y : x];

/** Without strict rules, friction nobody wrote is the library's default and not the field's 0. */
export function frictionOf(node: PhysicsNode): Vec2 {
  const strict = node.world.settings.asked('collisionRules') === 'strict';
  const meant = strict || node.authored('frictionCoefficients');
  return meant ? node.asked<Vec2>('frictionCoefficients') : [DEFAULT_FRICTION, DEFAULT_FRICTION];
}

/** Words that no parameter has. */
export const unknownTokens = (node: PhysicsNode): string[] =>
  node.asked<string[]>('appliedParameters').filter((token) => !TOKENS.has(normal(token)));

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

/** Nothing that Bullet would not do by itself. */
export const isPlain = (parameters: ContactParameters): boolean =>
  parameters.bounce === 0 &&
  parameters.friction.every((value) => value === DEFAULT_FRICTION) &&
  !isDirected(parameters) &&
  !isSoft(parameters);
