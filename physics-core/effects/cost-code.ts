// The chunk `costs`.
import { AutoLevel } from './costs/auto-level.js';
import type { costs } from './costs/effects.js';
import { FrameCosts } from './costs/frame-costs.js';
import { UserTiming } from './costs/user-timing.js';

export const provide = (): typeof costs.code => ({
  frameCosts: () => new FrameCosts(),
  userTiming: () => new UserTiming(),
  autoLevel: () => new AutoLevel(),
});
