/** What one field is edited to, and all that this may change. Items are those of `state.ts`. */
export interface Edit {
  /** Two values that act: neither the default, nor what the scene has. */
  values: readonly [unknown, unknown];
  /** Fields of the same node without which it has nothing to act on. */
  given?: Record<string, unknown>;
  /**
   * What differs after the edit, beside the field itself: `.field` and `~what` of the edited node, `name~what` of others,
   * `*~what` of several; after `?` what depends on more than this.
   */
  changes?: readonly string[];
  /** What stays different when the field is un-authored: the scene had a value that is not the default. */
  stays?: readonly string[];
  /** Un-authored there is nothing that it could be made of. */
  vanishes?: true;
  /** Bodies that touched do so no longer. */
  parts?: true;
  /** Codes of the problems that its author is told. */
  tells?: readonly string[];
  /** Codes of those that he may be told when it is un-authored: there is nothing left of what the scene had. */
  ends?: readonly string[];
}

/** Bullet has nothing of it, or nothing else than what reads the field. */
export const kept = (values: Edit['values'], changes: readonly string[] = []): Edit => ({
  values,
  changes,
});

export const ANGLES = [0.5, 0.7] as const;
export const SHARES = [0.25, 0.6] as const;
export const POINTS = [
  [0.1, 0.2, 0.3],
  [0.3, 0.2, 0.1],
] as const;
export const TURNS = [
  [0, 1, 0, 0.5],
  [0, 1, 0, 0.7],
] as const;
export const AXES = [
  [0.6, 0, 0.8],
  [0.8, 0, 0.6],
] as const;
export const ON = [true, false] as const;
export const OFF = [false, true] as const;
