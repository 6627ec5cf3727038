/** What pages have of a module of ours: `tree` is its syntax tree. */
export function plain(code: string, tree: unknown): string;
