import type { Chunk } from '../../base/chunk.js';
import { DRAG_MODES, type DragMode } from '../../dynamics/body.js';
import type { Drag } from '../../effects/drag/drag.js';
import type { DragEnd } from '../../effects/drag/hold.js';
import { dragging } from '../../effects/drag/dragging.js';
import { drags } from '../../effects/drag/effects.js';
import { contacts } from '../../effects/effect/chunks.js';
import type { Vec3 } from '../../fields/types.js';
import type { BodyNode } from './body.js';

/** Whether and how somebody may take hold of a body. */
export class BodyGrip {
  readonly #node: BodyNode;
  /** Held by a drag that heeds no force. */
  held = false;
  /** Whether somebody can take hold of it now. */
  offered = false;
  /** Whether it could move by itself when that was looked at. */
  #mayMove: boolean | undefined;

  constructor(node: BodyNode) {
    this.#node = node;
  }

  /** How it is dragged: by its own word, else by its collection's. */
  get mode(): DragMode {
    const node = this.#node;
    return (node.authored('dragMode') ? node : node.settings).asked('dragMode');
  }

  /** Whether people may drag it. What a collection says goes for the bodies that move: a floor is not meant. */
  get draggable(): boolean {
    const node = this.#node;
    const own = node.authored('draggableBody');
    if (!(own ? node : node.settings).asked<boolean>('draggableBody')) return false;
    return node.mayMove || (own && this.mode !== 'spring');
  }

  update(): void {
    const node = this.#node;
    this.#mayMove = node.mayMove;
    this.#reportFixed();
    const { draggable } = this;
    if (draggable === this.offered) return;
    this.offered = draggable;
    node.world.emit('draggable', node);
    if (!draggable) node.world.registry.find(dragging)?.letGo(node, 'disabled');
  }

  /** A mass is another: what is fixed can't be pulled. */
  massChanged(): void {
    if (this.#node.mayMove !== this.#mayMove) this.update();
  }

  updateMode(): void {
    this.update();
    this.#node.world.registry.find(dragging)?.modeChanged(this.#node);
  }

  #reportFixed(): void {
    const node = this.#node;
    const wanted = node.authored('draggableBody') && node.asked<boolean>('draggableBody');
    node.reportWhile(wanted && !this.draggable, {
      code: 'not-draggable',
      severity: 'warning',
      attribute: 'draggableBody',
      value: true,
      used: false,
      message: `${node.label} is fixed, and a spring moves no fixed body; ${DRAG_MODES.slice(1).join(' and ')} do`,
    });
  }

  /** It is there no more. */
  withdraw(): void {
    if (this.offered) this.#node.world.emit('draggable', this.#node);
    this.offered = false;
  }

  /** Code that it is not dragged or moved along without. */
  get needs(): (Chunk<unknown> | undefined)[] {
    const node = this.#node;
    const taken = node.world.registry.find(dragging)?.isNeededBy(node);
    const carried = !node.mayMove || this.mode === 'kinematic';
    return [taken || this.draggable ? drags : undefined, carried ? contacts : undefined];
  }

  take(point: Vec3, onend: (reason: DragEnd) => void): Drag | undefined {
    const node = this.#node;
    node.world.flush();
    const at = node.argument<Vec3>('drag', 'SFVec3f', point);
    const drag = at && node.world.registry.get(dragging).grab(node, at, onend);
    // Now it needs that.
    if (drag && !drags.here) node.touch('draggableBody');
    return drag;
  }

  /** Makes it immovable where it stands, or movable again: in Bullet the same body, and in the same joints. */
  hold(held: boolean): void {
    const node = this.#node;
    const wanted = held && node.mayMove;
    if (wanted === this.held) return;
    this.held = wanted;
    if (node.built) node.build.mobilityChanged();
  }
}
