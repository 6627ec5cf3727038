import type { BodyNode } from '../../nodes/body/body.js';
import type { NodeWorld, PairRules } from '../../nodes/node/node-world.js';

/** Collidables that no body owns, but that a CollisionCollection lists: each is an obstacle. */
export interface ObstacleRules {
  /** Something came, went, or was listed: who is an obstacle is looked at after the present edits. */
  due(): void;
  /** True where obstacles were made, which are edits in their turn. */
  update(): boolean;
  /** Before the Bullet world goes. */
  clear(): void;
}

/** Who meets whom in a world, and what stands in the way. */
export interface Meeting {
  readonly pairs: PairRules;
  readonly obstacles: ObstacleRules;
}

/** Makes that of a world; the code of contacts puts it here. */
export const meeting: { of?: (world: NodeWorld, bodies: Iterable<BodyNode>) => Meeting } = {};

const nothing = (): void => {};
const no = (): boolean => false;
const yes = (): boolean => true;

/** Without that code: a body is alone in its world, or nothing has been made yet. */
export const alone: Meeting = {
  obstacles: { due: nothing, update: no, clear: nothing },
  pairs: {
    refreshBody(body: BodyNode): void {
      if (body.built) body.presence.update();
    },
    groupsOf: () => [1, -1],
    wantsTriangles: no,
    refresh: nothing,
    contactsChanged: nothing,
    leave: nothing,
    addCollection: nothing,
    removeCollection: nothing,
    parametersChanged: nothing,
    addSpace: nothing,
    removeSpace: nothing,
    spacesChanged: nothing,
    watchChanged: nothing,
    between: nothing as () => undefined,
    collectionsOf: () => [],
    waits: no,
    speaksFor: no,
    meet: yes,
    collide: yes,
  },
};
