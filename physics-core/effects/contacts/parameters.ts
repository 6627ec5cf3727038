import { DEFAULT_FRICTION, type ContactParameters } from '../../dynamics/contact-parameters.js';
import type { Vec2 } from '../../fields/types.js';
import type { ParameterNode } from '../effect/chunks.js';

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
  node: ParameterNode,
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
export function frictionOf(node: ParameterNode): Vec2 {
  const strict = node.world.settings.asked<string>('collisionRules') === 'strict';
  const meant = strict || node.authored('frictionCoefficients');
  return meant ? node.asked<Vec2>('frictionCoefficients') : [DEFAULT_FRICTION, DEFAULT_FRICTION];
}

/** Words that no parameter has. */
export const unknownTokens = (node: ParameterNode): string[] =>
  node.asked<string[]>('appliedParameters').filter((token) => !TOKENS.has(normal(token)));
