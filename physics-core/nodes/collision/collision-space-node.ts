import { meshShapes } from '../../effects/contacts/mesh-shapes.js';
import { CollidableNode } from './collidable.js';
import { Members, type MemberList } from './members.js';
import { PhysicsNode } from '../node/node.js';

/** A group of collidables within CollisionCollections, to be switched on and off together. */
export class CollisionSpaceNode extends PhysicsNode {
  /** Collidables whose own triangles it wants. */
  exact = new Members();

  get members(): MemberList {
    return this.asked('collidables');
  }

  protected override create(): boolean {
    this.world.pairs.addSpace(this);
    return true;
  }

  protected override destroy(): void {
    this.world.pairs.removeSpace(this);
  }

  /** Its members, their members, or whether they count, have changed. */
  changed(): void {
    this.world.pairs.spacesChanged();
  }

  /** Bodies for which triangles come into or out of question get another shape. */
  updateGeometry(): void {
    const before = this.exact;
    const meshes = this.world.registry.find(meshShapes);
    this.exact = new Members(this.asked<boolean>('useGeometry') ? [this] : []);
    const every = before.all || this.exact.all;
    for (const collidable of every ? this.world.nodes : [...before.listed, ...this.exact.listed]) {
      if (!(collidable instanceof CollidableNode)) continue;
      const { owner } = collidable;
      const changed = before.has(collidable) !== this.exact.has(collidable);
      if (changed && owner && meshes?.isNeededBy(owner)) owner.touch('geometry');
    }
  }

  protected override released(): void {
    this.updateGeometry();
    this.changed();
  }
}
