import { DRAG_MODES, type Drag, type DragEnd, type DragMode } from '../effects/drag/drag.js';
import type { Vec3 } from '../fields/types.js';
import type { BodyNode } from './body.js';
import { MovingNode } from './body-motion.js';
import type { CollectionNode } from './rigid-body-collection.js';

/** A body that somebody may take hold of. */
export abstract class HeldNode extends MovingNode {
  /** Held by a drag that heeds no force. */
  protected held = false;
  #offered = false;

  abstract get settings(): Pick<CollectionNode, 'gravity' | 'asked' | 'authored'>;

  override get movable(): boolean {
    return !this.held && super.movable;
  }

  /** How it is dragged: by its own word, else by its collection's. */
  get dragMode(): DragMode {
    return (this.authored('dragMode') ? this : this.settings).asked('dragMode');
  }

  /** Whether people may drag it. What a collection says goes for the bodies that move: a floor is not meant. */
  get draggable(): boolean {
    const own = this.authored('draggableBody');
    if (!(own ? this : this.settings).asked<boolean>('draggableBody')) return false;
    return super.movable || (own && this.dragMode !== 'spring');
  }

  updateDraggable(): void {
    this.#reportFixed();
    const { draggable } = this;
    if (draggable === this.#offered) return;
    this.#offered = draggable;
    this.world.emit('draggable', this);
    if (!draggable) this.world.registry.dragging.letGo(this, 'disabled');
  }

  updateDragMode(): void {
    this.updateDraggable();
    this.world.registry.dragging.modeChanged(this as unknown as BodyNode);
  }

  #reportFixed(): void {
    const wanted = this.authored('draggableBody') && this.asked<boolean>('draggableBody');
    if (!wanted || this.draggable) {
      this.world.settle(this, 'draggableBody', 'not-draggable');
      return;
    }
    this.report({
      code: 'not-draggable',
      severity: 'warning',
      attribute: 'draggableBody',
      value: true,
      used: false,
      message: `${this.label} is fixed, and a spring moves no fixed body; ${DRAG_MODES.slice(1).join(' and ')} do`,
    });
  }

  /** It is there no more. */
  protected withdraw(): void {
    if (this.#offered) this.world.emit('draggable', this);
    this.#offered = false;
  }

  /** Whether somebody can take hold of it now. */
  get offered(): boolean {
    return this.#offered;
  }

  /**
   * Takes hold of it at a point of the world, metres; `onend` is told when it is over. Undefined where it can't be
   * held: not simulated, fixed and held by a spring, or held already by another mode.
   */
  drag(point: Vec3, onend: (reason: DragEnd) => void = () => {}): Drag | undefined {
    return this.world.events.during(() => {
      this.world.flush();
      const at = this.argument<Vec3>('drag', 'SFVec3f', point);
      return at && this.world.registry.dragging.grab(this as unknown as BodyNode, at, onend);
    });
  }

  /** Half the diagonal of the box around it, metres. */
  get size(): number {
    if (!this.built) return 0;
    const { scratch } = this.world.engine;
    const [low, high] = [scratch.vector(0, 0, 0, 0), scratch.vector(0, 0, 0, 1)];
    this.body.getAabb(low, high);
    return Math.hypot(high.x() - low.x(), high.y() - low.y(), high.z() - low.z()) / 2;
  }

  /** Makes it immovable where it stands, or movable again: in Bullet the same body, and in the same joints. */
  hold(held: boolean): void {
    const wanted = held && super.movable;
    if (wanted === this.held) return;
    this.held = wanted;
    if (this.built) this.mobilityChanged();
  }

  protected abstract mobilityChanged(): void;
}
