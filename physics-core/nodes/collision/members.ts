import type { Collidable } from '../../dynamics/collidable.js';
import { CollidableNode } from './collidable.js';
import type { PhysicsNode } from '../node/node.js';

/** What `collidables` of a space or collection names. */
export type MemberList = '*' | readonly PhysicsNode[];

/** A group among the members: a CollisionSpace. */
interface Space {
  readonly members: MemberList;
}

const isSpace = (node: PhysicsNode): node is PhysicsNode & Space => 'members' in node;

/** All collidables in a list of collidables and enabled spaces. */
export class Members {
  /** A list among them says `*`: every collidable of the world is in it, also those to come. */
  all = false;
  readonly listed = new Set<CollidableNode>();
  readonly #seen = new Set<PhysicsNode>();

  constructor(list: MemberList = []) {
    this.#add(list);
  }

  has(collidable: Collidable): boolean {
    return this.all || this.listed.has(collidable as CollidableNode);
  }

  #add(list: MemberList): void {
    if (list === '*') this.all = true;
    else this.#visitAll(list);
  }

  /** In order, however deep they stand in each other. */
  #visitAll(list: readonly PhysicsNode[]): void {
    const waiting = list.toReversed();
    for (let node = waiting.pop(); node; node = waiting.pop()) {
      const members = this.#visit(node);
      if (members === '*') this.all = true;
      else waiting.push(...members.toReversed());
    }
  }

  /** Returns the members of a space. */
  #visit(node: PhysicsNode): MemberList {
    // Spaces may stand in each other in a circle.
    if (node.removed || this.#seen.has(node)) return [];
    this.#seen.add(node);
    if (node instanceof CollidableNode) this.listed.add(node);
    return isSpace(node) && node.asked<boolean>('enabled') ? node.members : [];
  }
}
