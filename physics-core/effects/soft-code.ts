// Effects of the chunk `ropes`.
import { ropes } from './soft/effects.js';
import { Ropes } from './soft/ropes.js';

export function provideRopeEffects(): void {
  ropes.load = (simulation, effects) => new Ropes(simulation, effects);
}
