import { compose, identityPose, quaternionOf, type Pose } from '../../base/math.js';
import type { Rotation, Vec3 } from '../../fields/types.js';
import type { Geometry } from '../../shapes/geometry.js';
import type { Body } from '../../dynamics/body.js';
import type { CollidablePart } from '../../dynamics/collidable.js';
import { PhysicsNode } from '../node/node.js';

/** A geometry of a collidable, and its pose in the body's frame. */
export interface NodePart extends CollidablePart {
  collidable: CollidableNode;
}

/** The body whose shape a collidable makes, as the collidable knows it. */
export interface CollidableOwner extends Body {
  readonly built: boolean;
  readonly standsFor: PhysicsNode;
  /** A field of it follows from what changed here. */
  touch(field: string): void;
  settle(attribute?: string, code?: string): void;
}

/** What CollidableShape and CollidableOffset share: they make a body's shape, and belong to one body. */
export abstract class CollidableNode extends PhysicsNode {
  /** Those that name it, in order; the first owns it. */
  readonly #claims: (CollidableOwner | CollidableNode)[] = [];

  /** The body that the world made for it while no other owns it. */
  obstacle: CollidableOwner | undefined;

  /** The body whose shape it makes. */
  get owner(): CollidableOwner | undefined {
    const [first] = this.#claims;
    return first instanceof CollidableNode ? first.owner : (first ?? this.obstacle);
  }

  /** Whether neither a body nor an offset names it. */
  get unclaimed(): boolean {
    return this.#claims.length === 0;
  }

  /** Itself and the offsets around it. */
  get withOffsets(): CollidableNode[] {
    const [first] = this.#claims;
    return first instanceof CollidableNode ? [this, ...first.withOffsets] : [this];
  }

  /** Itself and the collidables inside it. */
  get withChildren(): CollidableNode[] {
    return [this];
  }

  abstract parts(): NodePart[];

  /** Its parts in its own frame. */
  abstract partsInside(): NodePart[];

  /** Its own pose where it stands free; inside an offset, its place there. */
  get place(): Pose {
    return {
      p: [...this.asked<Vec3>('translation')],
      q: quaternionOf(this.asked<Rotation>('rotation')),
    };
  }

  /** The pose a body without an authored one starts at. */
  get startPose(): Pose | undefined {
    return this.authored('translation') || this.authored('rotation') ? this.place : undefined;
  }

  claim(by: CollidableOwner | CollidableNode): void {
    if (this.#claims.includes(by)) return;
    this.#claims.push(by);
    this.world.obstacles.due();
    if (this.#claims[0] === by) return;
    by.report({
      code: 'already-owned',
      severity: 'warning',
      attribute: 'geometry',
      value: this.label,
      used: this.#claims[0]!.label,
      message: `${this.label} belongs to ${this.#claims[0]!.label}; ${by.label} goes without it until it is free`,
    });
  }

  releaseFrom(by: CollidableOwner | CollidableNode): void {
    const at = this.#claims.indexOf(by);
    if (at < 0) return;
    this.#claims.splice(at, 1);
    this.world.obstacles.due();
    by.settle('geometry', 'already-owned');
    const [next] = this.#claims;
    if (at > 0 || !next) return;
    next.settle('geometry', 'already-owned');
    next.touch(next instanceof CollidableNode ? 'collidable' : 'geometry');
  }

  /** Its shape or place changed. */
  changed(): void {
    this.owner?.touch('geometry');
  }

  protected override create(): boolean {
    this.world.obstacles.due();
    return true;
  }

  protected override released(): void {
    this.world.obstacles.due();
    this.owner?.touch('geometry');
  }
}

export class CollidableShapeNode extends CollidableNode {
  #geometries: readonly Geometry[] = [];

  updateShape(): void {
    this.#geometries = this.asked<Geometry[]>('shape');
    this.changed();
  }

  partsInside(): NodePart[] {
    return this.parts();
  }

  /** Directly in a body it sits at the body's pose; inside an offset its own place counts. */
  parts(displaced = false): NodePart[] {
    if (!this.asked<boolean>('enabled')) return [];
    const base = displaced ? this.place : identityPose();
    return this.#geometries.map((geometry) => ({
      geometry,
      pose: compose(base, {
        p: geometry.translation ?? [0, 0, 0],
        q: quaternionOf(geometry.rotation ?? [0, 0, 1, 0]),
      }),
      collidable: this,
    }));
  }
}

/** Collidables in one another, at most: each looks through all others. */
const DEEPEST = 100;

export class CollidableOffsetNode extends CollidableNode {
  #child: CollidableNode | undefined;

  parts(): NodePart[] {
    const { place } = this;
    return this.partsInside().map((part) => ({ ...part, pose: compose(place, part.pose) }));
  }

  partsInside(): NodePart[] {
    const child = this.#child;
    if (!child || child.removed || child.owner !== this.owner) return [];
    if (!this.asked<boolean>('enabled')) return [];
    return child instanceof CollidableShapeNode ? child.parts(true) : child.parts();
  }

  override get withChildren(): CollidableNode[] {
    return this.#child ? [this, ...this.#child.withChildren] : [this];
  }

  override get startPose(): undefined {
    return undefined;
  }

  updateChild(): void {
    const asked = this.asked<CollidableNode | null>('collidable') ?? undefined;
    const child = asked && !this.#isInside(asked) && !this.#isTooDeep(asked) ? asked : undefined;
    if (child !== this.#child) {
      this.#child?.releaseFrom(this);
      this.#child = child;
    }
    child?.claim(this);
    this.changed();
  }

  /** What stands in each other in a circle is nowhere. */
  #isInside(child: CollidableNode): boolean {
    if (!child.withChildren.includes(this)) return false;
    this.report({
      code: 'misplaced',
      severity: 'warning',
      attribute: 'collidable',
      value: child.label,
      used: 'nothing',
      message: `${this.label} can't hold ${child.label}, in which it stands itself; it holds nothing`,
    });
    return true;
  }

  #isTooDeep(child: CollidableNode): boolean {
    if (this.withOffsets.length + child.withChildren.length <= DEEPEST) return false;
    this.report({
      code: 'misplaced',
      severity: 'warning',
      attribute: 'collidable',
      value: child.label,
      used: 'nothing',
      message: `${this.label} holds nothing: it would be more than ${DEEPEST} deep in one another with ${child.label}`,
    });
    return true;
  }

  protected override released(): void {
    this.#child?.releaseFrom(this);
    super.released();
  }
}
