import { Chunk } from '../../base/chunk.js';
import type { Level } from '../../dynamics/levels.js';
import type { EffectDescriptor } from '../effect/effect.js';
import type { FrameCosts } from './frame-costs.js';
import type { UserTiming } from './user-timing.js';

/** A level that follows what frames cost. */
export interface FollowingLevel {
  level: Level;
  /** Begins anew at a level. */
  begin(level: Level): void;
  /** A frame that stood for `seconds` took `ms`. A verdict where the level changes. */
  note(ms: number, seconds: number, budget: number): Verdict | undefined;
}

export interface Verdict {
  level: Level;
  because: 'over budget' | 'room for more';
  /** Milliseconds of a frame that nine in ten stay below. */
  p90: number;
}

/** What looks at the costs of frames. */
interface CostCode {
  frameCosts(): FrameCosts;
  userTiming(): UserTiming;
  autoLevel(): FollowingLevel;
}

export const costs = new Chunk<CostCode>({
  name: 'costs',
  causes: 'accuracy auto, an `<x3d-physics-monitor>` in sight, `recordCosts()`, `world.profile`',
});

export const frameCosts: EffectDescriptor<FrameCosts> = {
  name: 'monitor',
  chunk: costs,
  causes: 'somebody who looks at what frames cost',
  load: () => costs.code.frameCosts(),
};

export const userTiming: EffectDescriptor<UserTiming> = {
  name: 'user timing',
  chunk: costs,
  causes: 'world.profile',
  load: () => costs.code.userTiming(),
};
