// The chunk `particle-elements`: X3D's component of particle systems in pages.
import { systemCode, particleTypes } from '../physics-core/particles.js';
import { learnTypes } from './bridge/index.js';
import { placeParticles } from './bridge/particles/place-particles.js';
import { defineElements } from './define.js';
import { X3DBoundedPhysicsModelElement } from './x3d-bounded-physics-model.js';
import { X3DConeEmitterElement } from './x3d-cone-emitter.js';
import { X3DExplosionEmitterElement } from './x3d-explosion-emitter.js';
import { X3DForcePhysicsModelElement } from './x3d-force-physics-model.js';
import { X3DParticleSystemElement } from './x3d-particle-system.js';
import { X3DPointEmitterElement } from './x3d-point-emitter.js';
import { X3DPolylineEmitterElement } from './x3d-polyline-emitter.js';
import { X3DSurfaceEmitterElement } from './x3d-surface-emitter.js';
import { X3DVolumeEmitterElement } from './x3d-volume-emitter.js';
import { X3DWindPhysicsModelElement } from './x3d-wind-physics-model.js';

export const particleClasses = [
  X3DParticleSystemElement,
  X3DConeEmitterElement,
  X3DExplosionEmitterElement,
  X3DPointEmitterElement,
  X3DPolylineEmitterElement,
  X3DSurfaceEmitterElement,
  X3DVolumeEmitterElement,
  X3DBoundedPhysicsModelElement,
  X3DForcePhysicsModelElement,
  X3DWindPhysicsModelElement,
];

/** With what moves particles. */
export async function whole(): Promise<{ provide(): void }> {
  await systemCode.load();
  return { provide };
}

function provide(): void {
  placeParticles();
  learnTypes(particleTypes);
  defineElements(particleClasses);
}
