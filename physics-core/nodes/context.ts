import type { World } from '../world/world.js';
import type { CollectionNode } from './rigid-body-collection.js';
import type { NodeType } from './table.js';

/** What a node is born with. */
export interface NodeContext {
  world: World;
  type: NodeType;
  id: number;
  /** Whatever stands for the node outside: its element in a page. Problems name it. */
  host: unknown;
  name: string | undefined;
  collection: CollectionNode | undefined;
  /** X3D version of the file it stands in, which says its defaults. */
  version?: number | undefined;
}
