import type { Joint } from '../../dynamics/joint.js';
import { Effect } from '../effect/effect.js';

/** Torques and forces between the bodies of joints. Motors that heed a rate are rows of the joint solve. */
export class Motors extends Effect {
  override beforeStep(dt: number): void {
    for (const node of this.inOrder) (node as Joint).push(dt);
  }
}
