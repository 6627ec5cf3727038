// The chunk `draw-rope`: draws ropes where they go.
import { RopeNode } from '../../../../physics-core/ropes.js';
import { OwnDrawing } from '../../matter/own-drawing.js';
import type { Binding } from '../../nodes/binding.js';
import type { X3DNode } from '../../x3dom/x3dom.js';
import { RopeShape } from './rope-shape.js';
import type { RopesDrawn } from './ropes-drawn.js';

const TUBE = 'tube';
const LINE = 'line';

const ofRope = new WeakMap<Binding, RopeDrawing>();

/** One Rope as x3dom draws it. */
class RopeDrawing extends OwnDrawing<RopeShape> {
  draw(): void {
    const { node, world, units } = this.binding;
    if (!(node instanceof RopeNode) || !world) return;
    const { places, velocities, moves } = node;
    const drawn = places && this.shapeNow();
    if (!drawn) return this.remove();
    const since = (1 - world.poses.fraction) * world.timeStep;
    drawn.show(
      { places, velocities: velocities!, moves, since },
      node.asked('radius'),
      units.length,
    );
  }

  /** What has no Material is no surface that could be lit. */
  protected override kindFor({ _cf }: X3DNode): string {
    return this.binding.node!.asked<number>('radius') > 0 && _cf.material?.node ? TUBE : LINE;
  }

  protected make(instead: X3DNode, appearance: X3DNode, kind: string): RopeShape {
    return new RopeShape(this.binding.element, instead, appearance, kind === TUBE);
  }
}

export const provide = (): RopesDrawn => ({
  show(rope, shapes) {
    const known = ofRope.get(rope) ?? new RopeDrawing(rope);
    ofRope.set(rope, known);
    known.changed(shapes);
  },
});
