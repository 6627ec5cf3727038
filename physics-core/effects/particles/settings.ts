import type { Body } from '../../dynamics/body.js';
import type { Vec3 } from '../../fields/types.js';
import type { Emitter } from './emit/emitter.js';
import type { Surface } from './surface.js';

/** A wind, as its author says it. */
export interface WindSettings {
  /** Where it blows; 0 0 0: each time elsewhere. */
  direction: Vec3;
  /** m/s. */
  speed: number;
  /** By which share of it gusts are faster or slower. */
  gustiness: number;
  /** 0: all goes with it; 1: anywhere. */
  turbulence: number;
}

/** What its author says of a particle system. */
export interface Settings {
  enabled: boolean;
  creates: boolean;
  /** Particles that live at once. */
  most: number;
  /** Seconds, and by which share of that some live longer or less long. */
  lifetime: number;
  lifetimeVariation: number;
  seed: number;
  /** Undefined: none, or nothing to emit from. */
  emitter: Emitter | undefined;
  /** All at once, at the beginning, and never again (ExplosionEmitter). */
  atOnce: boolean;
  /** Of each particle, kg and m²; without mass no force moves it. */
  mass: number;
  surfaceArea: number;
  /** Of the balls that they are to bodies and to water, metres. */
  radius: number;
  /** Linear drag, 1/s. */
  damping: number;
  /** Newtons on each particle. */
  force: Vec3;
  winds: readonly WindSettings[];
  /** Whether these push bodies, too. */
  blows: boolean;
  /** How it meets bodies and walls; undefined: it goes through all. */
  surface: Surface | undefined;
  /** What its emitter stands on. */
  body: Body | undefined;
}
