import type {
  DragEnd,
  DragMode,
  Hold,
  PhysicsNode,
  SoftSight,
  Vec3,
} from '../../../physics-core/inside.js';

/** What dragging asks of a node: of a body, a rope, a cloth or a soft body. */
export interface DraggableBody extends PhysicsNode {
  readonly offered: boolean;
  readonly dragMode: DragMode;
  readonly size: number;
  centerOfMassWorld(): Vec3;
  drag(point: Vec3, onend: (reason: DragEnd) => void): Hold | undefined;
}

/** What moves it. */
export type By = 'mouse' | 'touch' | 'pen' | 'keyboard';

/** What is no body of Bullet's says itself where a line of sight meets it. */
export interface Seen extends PhysicsNode {
  /** Which share of the line lies before it; undefined: it passes by, or it is no such node. */
  seen?(sight: SoftSight): number | undefined;
}
