// The chunk `drags`.
import { DragSpring, hangingMass } from './drag/drag-spring.js';
import { TOP_SPEED, type drags } from './drag/effects.js';
import { Hand } from './drag/hand.js';

export const provide = (): typeof drags.code => ({
  spring: (simulation, body, grip) => new DragSpring(simulation, body, grip),
  hand: (position) => new Hand(position, TOP_SPEED),
  handAs: (kept) => Hand.from(kept),
  massOf: hangingMass,
});
