import type { Chunk } from '../../base/chunk.js';
import { show } from '../../base/show.js';
import { drags } from '../../effects/drag/effects.js';
import type { DragEnd, Hold } from '../../effects/drag/hold.js';
import type { Grabbed } from '../../effects/drag/soft.js';
import type { SoftSight } from '../../effects/drag/soft-places.js';
import { swimming, water } from '../../effects/water/effects.js';
import type { Vec3 } from '../../fields/types.js';
import { codecs } from '../../fields/values.js';
import { PhysicsNode } from '../node/node.js';
import type { Field } from '../node/table.js';

/** Ropes, cloth and soft bodies, as people take hold of them: by a spring at the place that is nearest to where they do. */
export abstract class SoftNode extends PhysicsNode implements Grabbed {
  abstract readonly settings: Grabbed['settings'];
  /** Where its points are, metres, flat. */
  abstract readonly places: Float64Array | undefined;
  readonly dragMode = 'spring';
  /** Whether people can take hold of it now. */
  offered = false;

  protected abstract grab(point: Vec3, onend: (reason: DragEnd) => void): Hold | undefined;
  protected abstract letGo(): void;
  /** Which share of a line of sight lies before it; undefined: it passes by. */
  protected abstract seenAt(places: Float64Array, sight: SoftSight): number | undefined;

  /** Whether people may drag it: by its own word, else by its collection's. */
  get draggable(): boolean {
    const own = this.authored('draggableBody');
    return (own ? this : (this.collection ?? this.world.settings)).asked('draggableBody');
  }

  updateDraggable(): void {
    const offered = this.built && this.draggable;
    if (offered === this.offered) return;
    this.offered = offered;
    this.world.emit('draggable', this);
    if (!offered) this.letGo();
  }

  /** What acts on it, as plain data. */
  get inBullet(): Record<string, unknown> | undefined {
    const known = this.world.registry.find(water)?.knownOfMatter(this.id);
    return known && { water: known };
  }

  /** It is there no more. */
  protected override destroy(): void {
    if (this.offered) this.world.emit('draggable', this);
    this.offered = false;
  }

  drag(point: Vec3, onend: (reason: DragEnd) => void = () => {}): Hold | undefined {
    return this.world.events.call(this, 'drag', [point], () => {
      this.world.flush();
      const at = this.place('drag', point);
      return at && this.built ? this.grab(at, onend) : undefined;
    });
  }

  place(method: string, value: Vec3): Vec3 | undefined {
    const accepted = codecs.SFVec3f.accept(value) as Vec3 | undefined;
    if (accepted?.every(Number.isFinite)) return accepted;
    this.report({
      code: 'bad-value',
      severity: 'warning',
      value,
      used: 'nothing',
      message: `${this.label}: ${method} takes three finite numbers, not ${show(value)}; nothing is done`,
    });
    return undefined;
  }

  seen(sight: SoftSight): number | undefined {
    return this.places ? this.seenAt(this.places, sight) : undefined;
  }

  /** The middle of its points. */
  centerOfMassWorld(): Vec3 {
    const middle: Vec3 = [0, 0, 0];
    const places = this.places ?? [];
    for (let j = 0; j < places.length; j++) middle[j % 3]! += (3 * places[j]!) / places.length;
    return middle;
  }

  /** Of its points, the farthest from their middle, metres. */
  get size(): number {
    const middle = this.centerOfMassWorld();
    const places = this.places ?? [];
    let most = 0;
    for (let j = 0; j < places.length; j += 3) {
      let square = 0;
      for (let k = 0; k < 3; k++) square += (places[j + k]! - middle[k]!) ** 2;
      most = Math.max(most, square);
    }
    return Math.sqrt(most);
  }
}

/** Hands need the one; the other, whoever may come into water. */
export function softNeeds({ world }: SoftNode): (Chunk<unknown> | undefined)[] {
  const hasWater = [...world.nodes].some(({ type }) => type.containerField === 'waters');
  return [drags, hasWater ? swimming : undefined];
}

export const draggableBody: Field<SoftNode> = {
  type: 'SFBool',
  access: 'inputOutput',
  default: false,
  own: true,
  edit: 'live',
  patch: (node) => node.updateDraggable(),
  doc: 'TRUE: people may drag it by mouse, touch, pen and keyboard, at any place of it, by a spring. Not authored: as its collection.',
};
