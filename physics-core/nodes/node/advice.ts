import { Chunk } from '../../base/chunk.js';

/** What was probably meant by a name that there is not, and what that does here. */
export interface Advice {
  /** What a message adds to a field that a node has not; `names`: those that it has, as they are written there. */
  meant(asked: AskedField, names: readonly string[]): string;
  /** The same for a tag that is no node of `types`; undefined for what is none of ours. */
  meantNode(tag: string, types: readonly string[]): MeantNode | undefined;
}

export interface AskedField {
  name: string;
  /** The X3D name of the node. */
  type: string;
  value?: unknown;
}

export interface MeantNode {
  /** The X3D name of a node; undefined where none does that. */
  type: string | undefined;
  does: string;
}

/** Nobody needs it whose names are right. */
export const advice = new Chunk<Advice>({
  name: 'advice',
  causes: 'a tag or an attribute that there is not',
});

/** What a message adds to a name that is none of `names`; nothing before that is here, which it is from then on. */
export function meant(asked: AskedField, names: readonly string[]): string {
  if (advice.here) return advice.code.meant(asked, names);
  advice.load().catch(() => {});
  return '';
}
