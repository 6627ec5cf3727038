import type { Geometry } from '../shapes/geometry.js';
import type { NodeFields, NodeName } from './fields.js';
import type { NodeOf } from './nodes.js';

/** Three or more numbers, as a list, a typed array or X3D's text. */
export type Numbers = ArrayLike<number> | string;

/** Several such lists, one after another or each by itself. */
export type NumberLists = Numbers | readonly ArrayLike<number>[];

/** Words, as a list or X3D's text. */
export type Strings = readonly string[] | string;

/** A node that `add` gave, or the fields of one that is made for this place and goes with it. */
export type NodeInput<Name extends NodeName> = {
  [Each in Name]: NodeOf<Each> | ({ type: Each } & NodeFields[Each]);
}[Name];

/** What a body is made of: bare geometry does for a CollidableShape. */
export type CollidableInput = NodeInput<'CollidableShape' | 'CollidableOffset'> | Geometry;

/** One does where a list of one is meant. */
export type Several<Item> = Item | readonly Item[];
