// The chunk `swimming`.
import { Swimming } from './water/swimming.js';
import type { SwimmingCode } from './water/effects.js';

export const provide = (): SwimmingCode => ({
  swimming: (simulation) => new Swimming(simulation),
});
