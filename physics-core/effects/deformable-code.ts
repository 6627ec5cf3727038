// Effects of the chunk `deformables`.
import { Deformables } from './deformables/deformables.js';
import { deformables } from './deformables/effects.js';

export function provideDeformableEffects(): void {
  deformables.load = (simulation, effects) => new Deformables(simulation, effects);
}
