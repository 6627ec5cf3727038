import { deformables } from '../../effects/deformables/effects.js';
import type { Deformable } from '../../effects/deformables/deformable.js';
import type { DeformableSettings, DeformableSource } from '../../effects/deformables/settings.js';
import type { DragEnd, Hold } from '../../effects/drag/hold.js';
import { sightOfSurface, type SoftSight } from '../../effects/drag/soft-places.js';
import type { Value, Vec3 } from '../../fields/types.js';
import type { Geometry, Mesh } from '../../shapes/geometry.js';
import type { Material } from '../../solver/deformables/material.js';
import type { PhysicsNode } from '../node/node.js';
import { meshOf } from '../particles/mesh.js';
import { SoftNode } from './soft-node.js';

/** Points of a surface, at most: what has more is not there, and says so. */
export const MOST_POINTS = 20000;

/** What is softer by less is not told. */
const NEARLY = 0.95;

/** What Cloth and SoftBody have in common. */
export abstract class DeformableNode extends SoftNode implements DeformableSource {
  /** What ties points of it. */
  readonly tiedBy = deformables;
  #softened = false;
  #strained = false;

  get #deformable(): Deformable | undefined {
    return this.world.registry.find(deformables)?.of(this);
  }

  abstract lay(): Material;
  abstract read(material: Material): boolean;
  protected abstract readonly radius: number;
  protected abstract readonly stiffest: string;

  /** Its surface as it is laid. */
  get mesh(): Mesh {
    return meshOf(this.asked<Geometry | null>('geometry'));
  }

  get settings(): DeformableSettings {
    const collection = this.collection ?? this.world.settings;
    return {
      enabled: this.asked('enabled'),
      touches: true,
      radius: this.radius,
      damping: this.asked('damping'),
      friction: this.asked('friction'),
      fixed: this.asked('fixedIndex'),
      wind: undefined,
      selfCollision: false,
      gravity: collection.asked('gravity'),
      rests:
        collection.asked('rest') !== 'never' &&
        (collection.asked<boolean>('autoDisable') || !collection.authored('autoDisable')),
    };
  }

  /** Its gravity and rest are those of its collection. */
  override belongTo(collection: PhysicsNode | undefined): void {
    super.belongTo(collection);
    this.collectionChanged();
  }

  override collectionChanged(): void {
    if (!this.built) return;
    this.changed();
    this.updateDraggable();
  }

  changed(): void {
    this.world.registry.find(deformables)?.changed(this);
    this.#tellFixed();
  }

  #tellFixed(): void {
    const points = this.count;
    const beyond = this.asked<number[]>('fixedIndex').find((i) => i >= points);
    this.reportWhile(beyond !== undefined, {
      code: 'out-of-range',
      severity: 'warning',
      attribute: 'fixedIndex',
      value: beyond,
      used: 'nothing',
      message: `${this.label}: fixedIndex ${beyond} is no point of it: it has ${points}, counted from 0`,
    });
  }

  protected override create(): boolean {
    const why = this.#whyNot();
    this.reportWhile(why !== undefined, {
      code: 'bad-value',
      severity: 'warning',
      attribute: 'geometry',
      value: this.asked('geometry'),
      used: 'nothing',
      message: `${this.label} ${why}: it is not there`,
    });
    if (why) return false;
    this.world.registry.get(deformables).need(this, `a ${this.type.name}`);
    this.#tellFixed();
    return true;
  }

  #whyNot(): string | undefined {
    const { points, index } = this.mesh;
    if (points.length > 3 * MOST_POINTS)
      return `has ${points.length / 3} points, and ${MOST_POINTS} at most are simulated`;
    if (!points.every(Number.isFinite)) return 'has points that are no numbers';
    return this.whyNot({ points, index });
  }

  /** Why such a surface can't be simulated. */
  protected abstract whyNot(mesh: Mesh): string | undefined;

  protected override destroy(): void {
    super.destroy();
    this.world.registry.find(deformables)?.release(this);
  }

  protected override grab(point: Vec3, onend: (reason: DragEnd) => void): Hold | undefined {
    return this.world.registry.find(deformables)?.grab(this, point, onend);
  }

  protected override letGo(): void {
    this.world.registry.find(deformables)?.letGo(this);
  }

  protected override seenAt(places: Float64Array, sight: SoftSight): number | undefined {
    return sightOfSurface(places, this.triangles!, sight);
  }

  /** How many points its surface has. */
  get count(): number {
    return (this.places ?? this.mesh.points).length / 3;
  }

  /** Where points of its surface are, metres, flat. */
  get places(): Float64Array | undefined {
    return this.#deformable?.places;
  }

  /** How fast they went there in the last step, m/s, flat. */
  get velocities(): Float64Array | undefined {
    return this.#deformable?.velocities;
  }

  /** Its triangles, three points each. */
  get triangles(): Int32Array | undefined {
    return this.#deformable?.triangles;
  }

  /** Another number whenever they are elsewhere. */
  get moves(): number {
    return this.#deformable?.version ?? 0;
  }

  get positions(): Vec3[] {
    const places = this.places ?? this.mesh.points;
    return Array.from({ length: places.length / 3 }, (_, i): Vec3 => [
      places[3 * i]!,
      places[3 * i + 1]!,
      places[3 * i + 2]!,
    ]);
  }

  softened(share: number): void {
    const isSofter = share < NEARLY;
    if (isSofter === this.#softened) return;
    this.#softened = isSofter;
    const attribute = this.stiffest;
    const value = this.asked<number>(attribute);
    this.reportWhile(this.#softened, {
      code: 'soft-too-stiff',
      severity: 'warning',
      attribute,
      value,
      used: share * value,
      message: `${this.label}: ${attribute}="${value}" is more than steps of this accuracy follow: it is ${Math.round(100 * share)} % as stiff; a finer accuracy, or a coarser or heavier surface would follow it`,
    });
  }

  strained(strain: number): void {
    if (strain > 0 === this.#strained) return;
    this.#strained = strain > 0;
    this.reportWhile(this.#strained, {
      code: 'soft-too-stiff',
      severity: 'warning',
      value: strain,
      used: 'a longer one',
      message: `${this.label} bears more than steps of this accuracy hold: it is stretched by ${Math.round(100 * strain)} %; a finer accuracy, or less weight on it would hold`,
    });
  }

  stopped(): void {
    this.report({
      code: 'nan-state',
      severity: 'error',
      used: 'its last good place',
      message: `${this.label}: the simulation lost its numbers (NaN); it goes on from its last good place, at rest`,
    });
  }

  stepped(): void {
    if (this.heard('coord_changed')) this.emit('coord_changed', this.positions satisfies Value);
  }
}
