import { Chunk } from '../../../../physics-core/inside.js';
import type { Binding } from '../../nodes/binding.js';

/** What draws surfaces that move. */
export interface Surfaces {
  /** A water changed; these Shapes are what is seen of it. */
  show(water: Binding, shapes: readonly Element[]): void;
}

/** Nobody needs it whose water stands still. */
export const surfaces = new Chunk<Surfaces>({
  name: 'surface',
  causes: 'a WaterVolume whose waves are TRUE',
}).comesFrom(() => import('./draw-surface.js'));

/** Draws its surface if that moves, once what draws it is here; without that its Shapes stand still. */
export async function showSurface(water: Binding, shapes: readonly Element[]): Promise<void> {
  if (!surfaces.here) {
    if (!water.node?.asked('waves')) return;
    try {
      await surfaces.load();
    } catch {
      return;
    }
  }
  surfaces.code.show(water, shapes);
}
