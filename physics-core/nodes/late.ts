import type { NodeDefinition } from './node/define.js';
import { byName } from './node/table.js';

/** Node types whose tables come in a chunk, by their X3D names. */
export const lateTypes: Record<string, NodeDefinition> = byName({});
