import { lateWorlds } from '../document/world-for.js';
import { planners } from '../plans/plans.js';
import { planWater, worldOfWater } from './plan-water.js';

/** Has what reads the document place water. */
export function placeWater(): void {
  planners.WaterVolume = planWater;
  lateWorlds.WaterVolume = worldOfWater;
}
