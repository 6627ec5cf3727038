import type { NodeDefinition } from '../node/define.js';
import { byName } from '../node/table.js';
import { softBodyAttachment } from './attachment.js';
import { rope } from './rope.js';

/** Nodes of ropes, by their names. */
export const softTypes: Readonly<Record<string, NodeDefinition>> = byName({
  Rope: rope,
  SoftBodyAttachment: softBodyAttachment,
});
