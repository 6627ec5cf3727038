/** A plain-data value with a `type`, from which a node is made. */
export interface NodeData {
  type: string;
  [field: string]: unknown;
}

export const isNodeData = (item: unknown): item is NodeData =>
  typeof item === 'object' && item !== null && 'type' in item && typeof item.type === 'string';
