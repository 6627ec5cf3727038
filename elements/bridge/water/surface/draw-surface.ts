// The chunk `surface`: draws water whose surface moves.
import { WaterVolumeNode } from '../../../../physics-core/water.js';
import { matrixOf } from '../../geometry/matrix.js';
import { OwnDrawing } from '../../matter/own-drawing.js';
import type { Binding } from '../../nodes/binding.js';
import type { X3DNode } from '../../x3dom/x3dom.js';
import { SurfaceShape } from './surface-shape.js';
import type { Surfaces } from './surfaces.js';

const ofWater = new WeakMap<Binding, SurfaceDrawing>();

/** One WaterVolume as x3dom draws it. */
class SurfaceDrawing extends OwnDrawing<SurfaceShape> {
  draw(): void {
    const { node, units } = this.binding;
    const shown = node instanceof WaterVolumeNode ? node.surface : undefined;
    const drawn = shown && this.shapeNow();
    if (!drawn) return this.remove();
    const { pose, size } = (node as WaterVolumeNode).settings;
    const m = matrixOf({ position: [...pose.p], quaternion: [...pose.q] });
    drawn.show(shown, {
      axes: [m[0], m[4], m[8], m[1], m[5], m[9], m[2], m[6], m[10]],
      middle: pose.p,
      depth: size[1],
      unit: units.length,
    });
  }

  protected make(instead: X3DNode, appearance: X3DNode): SurfaceShape {
    return new SurfaceShape(instead, appearance);
  }
}

export const provide = (): Surfaces => ({
  show(water, shapes) {
    const known = ofWater.get(water) ?? new SurfaceDrawing(water);
    ofWater.set(water, known);
    known.changed(shapes);
  },
});
