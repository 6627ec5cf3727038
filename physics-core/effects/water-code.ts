// Effects of the chunk `water`.
import { water } from './water/effects.js';
import { Water } from './water/water.js';

export function provideWaterEffects(): void {
  water.load = (simulation, effects) => new Water(simulation, effects);
}
