import type { CollisionEnd } from '../effects/contacts/touches.js';
import type { EffectReport } from '../effects/effect/report.js';
import type { Timeline } from './recording.js';
import type { Snapshot } from './snapshot/snapshot.js';
import type { Stats } from './store/types.js';

/** A world whose steps are taken on another thread, as it is asked here. */
export interface Elsewhere {
  /** The step that came back last. */
  readonly step: number;
  readonly stats: Stats;
  readonly effects: EffectReport[];
  ask(method: string, args: readonly unknown[]): Promise<unknown>;
  /** Somebody wants to know at once what only the other thread knows. */
  refuse(method: string): null;
  /** This world was reset; whether the other is to go on with it. */
  begunAnew(goesOn: boolean): void;
  /** This world was restored. */
  restored(snapshot: Snapshot): void;
  /** Keeps there what it does, so many simulated seconds of it. */
  record(seconds: number): Promise<Timeline>;
  /** Goes on here from where it is there; settles when it does. */
  comeBack(bound: Bound): Promise<void>;
  /** Bullet's bodies stand here where they stand there. */
  place(): void;
  /** The other thread ends, and what touches there. */
  end(reason?: CollisionEnd): void;
  /** Contact points, for who draws them: those of the answer that came last, from the next one on. */
  readonly contacts: Float64Array;
}

/** Why a world has to run where its page is, and the element that says so. */
export interface Bound {
  why: string;
  host?: unknown;
}
