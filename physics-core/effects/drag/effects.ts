import { Chunk } from '../../base/chunk.js';
import type { Body } from '../../dynamics/body.js';
import type { Simulation } from '../../dynamics/simulation.js';
import type { Vec3 } from '../../fields/types.js';
import { contacts } from '../effect/chunks.js';
import type { EffectDescriptor } from '../effect/effect.js';
import type { Carrying } from './carrying.js';
import type { DragSpring } from './drag-spring.js';
import type { Hand, KeptHand } from './hand.js';

/** m/s: no hand moves faster, and what it lets go of flies no faster. */
export const TOP_SPEED = 8;

/** rad/s: the grabbed point comes within 1 % of its way in 0.22 s. */
export const SWIFTNESS = 30;

/** What only that needs which somebody holds. */
interface DragCode {
  /** `grip`: the grabbed point, in the body's frame. */
  spring(simulation: Simulation, body: Body, grip: Vec3): DragSpring;
  /** Of who takes hold there. */
  hand(position: Vec3): Hand;
  handAs(kept: KeptHand): Hand;
  /** Of bodies and of all movable ones that joints tie to them, kg. */
  massOf(bodies: Iterable<Body>): number;
}

export const drags = new Chunk<DragCode>({
  name: 'drags',
  causes:
    'a body that may be dragged, or that `drag()` takes hold of; a Rope, a Cloth or a SoftBody',
});

/** What is moved along pushes and takes along what it touches. */
export const carrying: EffectDescriptor<Carrying> = {
  name: 'carrying',
  chunk: contacts,
  causes: 'a fixed body that a ROUTE, a Transform above it or a hand moves along',
};
