import type { SoftRunning, SoftScene } from './scene.js';

/** What a run is set to. */
export interface SoftSetting {
  /** One of our levels, in others null. */
  level: string | null;
  /** Seconds of a step. */
  step: number;
  /** Rounds of the others' solvers in a step; ours has none to be told. */
  iterations: number | null;
  /** Jolt's, with points that are kept within their reach of the nearest fixed one (LRA constraints). */
  reaches?: boolean;
}

/** A library that has ropes and cloths. */
export interface SoftEngine {
  id: string;
  name: string;
  /** The package that has it, where it is not ours. */
  package?: string;
  /** How it is run here, in a sentence. */
  says: string;
  /** From cheap to dear. */
  settings(scene: SoftScene): SoftSetting[];
  make(scene: SoftScene, setting: SoftSetting): Promise<SoftRunning>;
}
