import { Chunk } from '../../../../physics-core/inside.js';
import type { Binding } from '../../nodes/binding.js';
import type { SurfaceData } from './surface-data.js';

/** What draws cloth and soft bodies. */
export interface DeformablesDrawn {
  /** One changed; these Shapes are what is seen of it. */
  show(soft: Binding, shapes: readonly Element[], surface: SurfaceData | undefined): void;
}

/** Nobody needs it whose cloth and soft bodies have no Shapes. */
export const deformablesDrawn = new Chunk<DeformablesDrawn>({
  name: 'deformable drawing',
  causes: 'a Cloth or a SoftBody with a Shape',
}).comesFrom(() => import('./draw-deformable.js'));

/** Draws it, once what does so is here; without that its Shape stands still. */
export async function showDeformable(
  soft: Binding,
  shapes: readonly Element[],
  surface: SurfaceData | undefined,
): Promise<void> {
  if (!deformablesDrawn.here) {
    if (!soft.node || shapes.length === 0) return;
    try {
      await deformablesDrawn.load();
    } catch {
      return;
    }
  }
  deformablesDrawn.code.show(soft, shapes, surface);
}
