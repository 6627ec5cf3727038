import type { NodeDefinition } from '../node/define.js';
import { byName } from '../node/table.js';
import { cloth } from './cloth.js';
import { softBody } from './soft-body.js';

/** Nodes of cloth and soft bodies, by their names. */
export const deformableTypes: Readonly<Record<string, NodeDefinition>> = byName({
  Cloth: cloth,
  SoftBody: softBody,
});
