// The chunk `draw-deformable`: draws cloth and soft bodies where they go.
import { DeformableNode } from '../../../../physics-core/deformables.js';
import { OwnDrawing } from '../../matter/own-drawing.js';
import type { Binding } from '../../nodes/binding.js';
import type { X3DNode } from '../../x3dom/x3dom.js';
import { spread, type SurfaceData } from './surface-data.js';
import type { DeformablesDrawn } from './deformables-drawn.js';
import { SurfaceShape } from './surface-shape.js';

const drawings = new WeakMap<Binding, DeformableDrawing>();

/** One Cloth or SoftBody as x3dom draws it. */
class DeformableDrawing extends OwnDrawing<SurfaceShape> {
  surface: SurfaceData | undefined;

  draw(): void {
    const { node, world, units } = this.binding;
    if (!(node instanceof DeformableNode) || !world) return;
    const { places, velocities, triangles, moves } = node;
    const drawn = places && triangles!.length > 0 && this.shapeNow();
    if (!drawn) return this.remove();
    const since = (1 - world.poses.fraction) * world.timeStep;
    drawn.show(
      { places, velocities: velocities!, triangles: triangles!, moves, since },
      {
        laid: () => node.mesh.points,
        said: this.surface,
        surface: () => sheetOf(node) ?? this.surface,
        isSolid: node.type.name === 'SoftBody',
      },
      units.length,
    );
  }

  protected make(instead: X3DNode, appearance: X3DNode): SurfaceShape {
    return new SurfaceShape(this.binding.element, instead, appearance);
  }
}

/** A Cloth with a size is a sheet, whatever stands in it. */
function sheetOf(node: DeformableNode): SurfaceData | undefined {
  if (!node.type.fields.size) return undefined;
  const [width, height] = node.asked<[number, number]>('size');
  if (!(width > 0 && height > 0)) return undefined;
  const [columns, rows] = node
    .asked<[number, number]>('subdivision')
    .map((n) => Math.max(1, Math.round(n))) as [number, number];
  return { geometry: { type: 'Mesh' }, texture: { places: spread(columns, rows) } };
}

export const provide = (): DeformablesDrawn => ({
  show(soft, shapes, surface) {
    const known = drawings.get(soft) ?? new DeformableDrawing(soft);
    drawings.set(soft, known);
    known.surface = surface;
    known.changed(shapes);
  },
});
