import { Chunk } from '../../../../physics-core/inside.js';
import type { Binding } from '../../nodes/binding.js';

/** What draws ropes. */
export interface RopesDrawn {
  /** A rope changed; these Shapes are what is seen of it. */
  show(rope: Binding, shapes: readonly Element[]): void;
}

/** Nobody needs it whose ropes have no Shapes. */
export const ropesDrawn = new Chunk<RopesDrawn>({
  name: 'rope drawing',
  causes: 'a Rope with a Shape',
}).comesFrom(() => import('./draw-rope.js'));

/** Draws it, once what does so is here; without that its Shape stands still. */
export async function showRope(rope: Binding, shapes: readonly Element[]): Promise<void> {
  if (!ropesDrawn.here) {
    if (!rope.node || shapes.length === 0) return;
    try {
      await ropesDrawn.load();
    } catch {
      return;
    }
  }
  ropesDrawn.code.show(rope, shapes);
}
