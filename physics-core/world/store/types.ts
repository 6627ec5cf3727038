import type { Level } from '../../dynamics/levels.js';
import type { Pose } from '../../base/math.js';
import type { PhysicsNode } from '../../nodes/node/node.js';
import type { Console } from './reporting.js';

export interface WorldOptions {
  /** Log each problem once to the console, or to what is given. */
  console?: Console;
  /** Bytes the wasm heap may take. */
  maxHeapBytes?: number;
  /** In place of any level that the collection asks for: a step and iterations of one's own, to measure with. */
  level?: Level;
}

export interface AddOptions {
  /** What stands for the node outside: its element. */
  host?: unknown;
  /** Its DEF or id. */
  name?: string | undefined;
  /** The RigidBodyCollection it belongs to, where the world has several. */
  collection?: PhysicsNode | undefined;
  /** X3D version of its file, 4 by default: some defaults were others in X3D 3. */
  version?: number | undefined;
  /** Where a body starts whose author gave no position or orientation. */
  start?: Pose | undefined;
  /** That of the node it is a copy of. */
  id?: number | undefined;
}

export interface Stats {
  bodies: number;
  awake: number;
  joints: number;
  contacts: number;
  /** Objects made, edits applied without making anything, objects unmade, since the world began. */
  created: number;
  patched: number;
  destroyed: number;
  heapBytes: number;
  /** Seconds of the clock dropped since the world began, because frames came too late or steps took too long. */
  dropped: number;
  /** Milliseconds of the last frame. */
  ms: { step: number; read: number; write: number; events: number };
  /** In a page where bodies look alike: how many calls draw them, and how many fewer that are than bodies. */
  batches?: number;
  drawsSaved?: number;
}
