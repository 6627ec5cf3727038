import { CollidableNode } from './collidable.js';
import { PhysicsNode } from './node.js';
import { defineNode } from './table.js';

/** What `collidables` of a space or collection names. */
export type Member = CollidableNode | CollisionSpaceNode;

/** A group of collidables within CollisionCollections, to be switched on and off together. */
export class CollisionSpaceNode extends PhysicsNode {
  /** Collidables whose own triangles it wants. */
  exact: ReadonlySet<CollidableNode> = new Set();

  get members(): Member[] {
    return this.asked('collidables');
  }

  protected override create(): boolean {
    this.world.pairs.spaces.add(this);
    return true;
  }

  protected override destroy(): void {
    this.world.pairs.spaces.delete(this);
  }

  /** Its members, their members, or whether they count, have changed. */
  changed(): void {
    const { collections, spaces } = this.world.pairs;
    for (const collection of collections) collection.updateMembers();
    for (const space of spaces) space.updateGeometry();
  }

  /** Bodies for which triangles come into or out of question get another shape. */
  updateGeometry(): void {
    const before = this.exact;
    const { meshes } = this.world.registry;
    this.exact = this.asked<boolean>('useGeometry') ? flatten([this]) : new Set();
    for (const collidable of new Set([...before, ...this.exact])) {
      const { owner } = collidable;
      const changed = before.has(collidable) !== this.exact.has(collidable);
      if (changed && owner && meshes.isNeededBy(owner)) owner.touch('geometry');
    }
  }

  protected override released(): void {
    this.updateGeometry();
    this.changed();
  }
}

/** All collidables in a list of collidables and enabled spaces. */
export function flatten(list: readonly Member[]): Set<CollidableNode> {
  const found = new Set<CollidableNode>();
  const seen = new Set<CollisionSpaceNode>();
  const visit = (member: Member): void => {
    if (member.removed) return;
    if (member instanceof CollidableNode) found.add(member);
    if (!(member instanceof CollisionSpaceNode) || seen.has(member)) return;
    seen.add(member);
    if (member.asked<boolean>('enabled')) member.members.forEach(visit);
  };
  list.forEach(visit);
  return found;
}

const changed = (space: CollisionSpaceNode): void => space.changed();

export const collisionSpace = defineNode<CollisionSpaceNode>({
  name: 'CollisionSpace',
  containerField: 'collidables',
  clause: '37.4.6',
  doc: 'Collidables of a CollisionCollection that are switched on and off together.',
  rank: 1,
  bounded: true,
  make: (context) => new CollisionSpaceNode(context),
  fields: {
    enabled: {
      type: 'SFBool',
      access: 'inputOutput',
      default: true,
      edit: 'live',
      patch: changed,
      doc: 'FALSE: its collidables are in the collection only where they are in it by another way.',
    },
    collidables: {
      type: 'MFNode',
      access: 'inputOutput',
      default: [],
      nodes: ['CollidableShape', 'CollidableOffset', 'CollisionSpace'],
      edit: 'live',
      patch: changed,
      doc: 'The members: collidables and further spaces.',
    },
    useGeometry: {
      type: 'SFBool',
      access: 'inputOutput',
      default: false,
      edit: 'live',
      patch: (space) => space.updateGeometry(),
      doc: 'FALSE: a moving mesh may collide as its convex hull. TRUE: its own triangles.',
    },
  },
});
