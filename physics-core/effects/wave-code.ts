// The chunk `waves`.
import { waves } from './water/effects.js';
import { Waves } from './water/waves/waves.js';

export function provide(): void {
  waves.load = (simulation) => new Waves(simulation);
}
