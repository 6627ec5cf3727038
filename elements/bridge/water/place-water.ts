import { lateWorlds } from '../document/world-for.js';
import { worldAround } from '../matter/world-of.js';
import { planners } from '../plans/plans.js';
import { planWater } from './plan-water.js';

/** Has what reads the document place water. */
export function placeWater(): void {
  planners.WaterVolume = planWater;
  lateWorlds.WaterVolume = worldAround;
}
