/** Three or more numbers, as a list, a typed array or X3D's text. */
export type Numbers = ArrayLike<number> | string;

/** Several such lists, one after another or each by itself. */
export type NumberLists = Numbers | readonly ArrayLike<number>[];

/** Words, as a list or X3D's text. */
export type Strings = readonly string[] | string;

/** One does where a list of one is meant. */
export type Several<Item> = Item | readonly Item[];
