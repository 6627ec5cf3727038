import type { SoftRunning, SoftScene } from './scene.js';

/** One number that says how wrong a run is: metres, or a share of what is right. */
export interface Judged {
  id: string;
  name: string;
  unit: 'm' | 'share';
  /** What ours is to keep at `standard`, where anything is asked. */
  aim?: number;
  /** Below this, numbers say what rounding does, not the method. */
  floor: number;
}

/** A scene of which the truth is known, and how far off a run of it is. */
export interface SoftCase {
  id: string;
  name: string;
  scene: SoftScene;
  judged: readonly Judged[];
  /** Our finest level that it is run at, where finer ones take minutes. */
  finest?: string;
  /** Takes it to its end; how far off each is that is judged. */
  run(running: SoftRunning): Record<string, number>;
}

/** m/s² */
export const G = 9.8;
