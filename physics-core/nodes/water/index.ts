import type { NodeDefinition } from '../node/define.js';
import { byName } from '../node/table.js';
import { waterVolume } from './water-volume.js';

/** Nodes of water, by their names. */
export const waterTypes: Readonly<Record<string, NodeDefinition>> = byName({
  WaterVolume: waterVolume,
});
