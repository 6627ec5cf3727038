// The chunk `drags`.
import { DragSpring } from './drag/drag-spring.js';
import type { drags } from './drag/effects.js';
import { SoftHands } from './drag/soft-hands.js';
import * as places from './drag/soft-places.js';

export const provide = (): typeof drags.code => ({
  spring: (simulation, body, grip) => new DragSpring(simulation, body, grip),
  softHands: (simulation, world) => new SoftHands(simulation, world),
  places,
});
