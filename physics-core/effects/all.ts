import { contactReader } from './contacts/contact-reader.js';
import { contactSurface } from './contacts/contact-surface.js';
import { givenContacts } from './contacts/given-contacts.js';
import { meshShapes } from './contacts/mesh-shapes.js';
import { pairFilter } from './contacts/pair-filter.js';
import { contactSolve } from './contact-solve/contact-solve.js';
import { frameCosts } from './costs/frame-costs.js';
import { userTiming } from './costs/user-timing.js';
import { debugging } from './debug/debugging.js';
import { carrying } from './drag/carrying.js';
import { dragging } from './drag/dragging.js';
import type { EffectDescriptor } from './effect/effect.js';
import { axisDamping } from './flight/axis-damping.js';
import { flight } from './flight/flight.js';
import { forces } from './flight/forces.js';
import { gyroscopic } from './flight/gyroscopic.js';
import { continuousCollision } from './hits/continuous-collision.js';
import { impactPropagation } from './hits/impact-propagation.js';
import { jointSolve } from './joints/joint-solve.js';
import { motors } from './joints/motors.js';
import { stops } from './joints/stops.js';
import { suspension } from './joints/suspension.js';
import { contactShapes } from './manifolds/contact-shapes.js';
import { inOrder } from './effect/order.js';
import { resting } from './rest/resting.js';

/** Every effect there is, in the order in which a step calls them. */
export const allEffects: readonly EffectDescriptor[] = inOrder([
  contactShapes,
  forces,
  axisDamping,
  flight,
  gyroscopic,
  suspension,
  dragging,
  motors,
  stops,
  impactPropagation,
  continuousCollision,
  pairFilter,
  jointSolve,
  contactSurface,
  givenContacts,
  contactSolve,
  carrying,
  contactReader,
  meshShapes,
  resting,
  debugging,
  frameCosts,
  userTiming,
]);
