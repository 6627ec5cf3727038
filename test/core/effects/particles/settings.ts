import type { Emitter } from '../../../../physics-core/effects/particles/emit/emitter.js';
import type { Settings } from '../../../../physics-core/effects/particles/settings.js';

/** Born at 1 2 3 with 3 4 5 m/s. */
const steady: Emitter = {
  emit(_, birth) {
    birth.set([1, 2, 3, 3, 4, 5]);
    return true;
  },
};

/** Of a system that nobody said more of. */
export const PLAIN: Settings = {
  enabled: true,
  creates: true,
  most: 10,
  lifetime: 5,
  lifetimeVariation: 0,
  seed: 1,
  emitter: steady,
  atOnce: false,
  mass: 1,
  surfaceArea: 0,
  radius: 0.01,
  damping: 0,
  force: [0, 0, 0],
  winds: [],
  blows: false,
  surface: undefined,
  body: undefined,
};
