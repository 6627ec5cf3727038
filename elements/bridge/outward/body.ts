import type { DragEnd, DragMode, Hold, PhysicsNode, Vec3 } from '../../../physics-core/inside.js';

/** What dragging asks of a body's node. */
export interface DraggableBody extends PhysicsNode {
  readonly offered: boolean;
  readonly dragMode: DragMode;
  readonly size: number;
  centerOfMassWorld(): Vec3;
  drag(point: Vec3, onend: (reason: DragEnd) => void): Hold | undefined;
}

/** What moves it. */
export type By = 'mouse' | 'touch' | 'pen' | 'keyboard';
