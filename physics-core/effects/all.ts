import { contactReader, contactSurface, givenContacts, pairFilter } from './contacts/effects.js';
import { meshShapes } from './contacts/mesh-shapes.js';
import { contactSolve } from './contact-solve/effects.js';
import { frameCosts, userTiming } from './costs/effects.js';
import { debugging } from './debug/debugging.js';
import { carrying } from './drag/effects.js';
import { dragging } from './drag/dragging.js';
import type { EffectDescriptor } from './effect/effect.js';
import { axisDamping } from './flight/axis-damping.js';
import { flight } from './flight/flight.js';
import { forces } from './flight/forces.js';
import { fullTurns } from './flight/full-turns.js';
import { gyroscopic } from './flight/gyroscopic.js';
import { continuousCollision, impactPropagation, sweptEnds } from './hits/effects.js';
import { jointSolve, motors, stops, suspension } from './joints/effects.js';
import { contactShapes } from './manifolds/effects.js';
import { particles } from './particles/effects.js';
import { deformables } from './deformables/effects.js';
import { ropes } from './soft/effects.js';
import { water, waves } from './water/effects.js';
import { inOrder } from './effect/order.js';
import { resting } from './rest/resting.js';

/** Every effect there is, in the order in which a step calls them. */
export const allEffects: readonly EffectDescriptor[] = inOrder([
  contactShapes,
  forces,
  axisDamping,
  fullTurns,
  flight,
  gyroscopic,
  suspension,
  dragging,
  motors,
  stops,
  impactPropagation,
  continuousCollision,
  sweptEnds,
  pairFilter,
  jointSolve,
  contactSurface,
  givenContacts,
  contactSolve,
  carrying,
  particles,
  waves,
  water,
  ropes,
  deformables,
  contactReader,
  meshShapes,
  resting,
  debugging,
  frameCosts,
  userTiming,
]);
