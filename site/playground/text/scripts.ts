// Scripts of a text, which run in the scene's page.
import { elementsIn, type ElementNode, type TreeNode } from './tree.js';

export const isScript = ({ tag }: ElementNode): boolean => tag.toLowerCase() === 'script';

export const scriptsIn = (roots: readonly TreeNode[]): ElementNode[] =>
  [...elementsIn(roots)].filter(isScript);
