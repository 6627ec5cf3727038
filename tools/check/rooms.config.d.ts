/** A tree of files that are parted into rooms. */
export interface Described {
  root: string;
  /** From the bottom up. */
  rooms: string[];
  /** Circles of files that stay, however large: the members of each, without the root. */
  circles: string[][];
}

export const trees: Record<string, Described>;
export const TOP: string;
