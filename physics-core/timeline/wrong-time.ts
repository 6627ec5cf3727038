import { show } from '../base/show.js';
import type { World } from '../world/world.js';

export const reportWrongTime = (world: World, time: unknown): void =>
  world.report({
    code: 'bad-value',
    severity: 'warning',
    attribute: 'seek',
    value: time,
    used: 'nothing',
    message: `seek takes a time in seconds, not ${show(time)}; nothing is done`,
  });
