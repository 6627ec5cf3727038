import { show } from '../base/show.js';
import type { World } from '../world/world.js';

export const A_TIME = 'a time in seconds';

export const refuse = (world: World, attribute: string, takes: string, value: unknown): void =>
  world.report({
    code: 'bad-value',
    severity: 'warning',
    attribute,
    value,
    used: 'nothing',
    message: `${attribute} takes ${takes}, not ${show(value)}; nothing is done`,
  });
