// The chunk `drags`.
import { DragSpring } from './drag/drag-spring.js';
import type { drags } from './drag/effects.js';

export const provide = (): typeof drags.code => ({
  spring: (simulation, body, grip) => new DragSpring(simulation, body, grip),
});
