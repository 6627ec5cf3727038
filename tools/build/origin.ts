import type { NodeType } from '../../physics-core/inside.js';

/** Where it is laid down what a node is. */
export const originOf = ({ clause }: NodeType): string =>
  clause
    ? `ISO/IEC 19775-1, clause ${clause}`
    : 'a node of our own, which the standard does not have';
