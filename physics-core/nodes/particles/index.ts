import type { NodeDefinition } from '../node/define.js';
import { byName } from '../node/table.js';
import { boundedPhysicsModel } from './bounded-physics-model.js';
import { coneEmitter } from './cone-emitter.js';
import { explosionEmitter } from './explosion-emitter.js';
import { forcePhysicsModel } from './force-physics-model.js';
import { particleSystem } from './particle-system.js';
import { pointEmitter } from './point-emitter.js';
import { polylineEmitter } from './polyline-emitter.js';
import { surfaceEmitter } from './surface-emitter.js';
import { volumeEmitter } from './volume-emitter.js';
import { windPhysicsModel } from './wind-physics-model.js';

const all: readonly NodeDefinition[] = [
  particleSystem,
  coneEmitter,
  explosionEmitter,
  pointEmitter,
  polylineEmitter,
  surfaceEmitter,
  volumeEmitter,
  boundedPhysicsModel,
  forcePhysicsModel,
  windPhysicsModel,
];

/** X3D's particle component, by its names. */
export const particleTypes: Readonly<Record<string, NodeDefinition>> = byName(
  Object.fromEntries(all.map((type) => [type.name, type])),
);
