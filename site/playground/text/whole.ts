// A text may be a page, an <x3d>, a scene, or a few nodes: what is missing around them is put there.
import { isProse } from './left-out.js';
import { parse } from './parse.js';
import { elementsIn, isElement, type ElementNode, type TreeNode } from './tree.js';

const STAGE = `<x3d><scene>
<viewpoint position="0 3.4 9" orientation="1 0 0 -0.2" centerOfRotation="0 1.5 0"></viewpoint>
<background transparency="1"></background>
<navigationinfo headlight="false"></navigationinfo>
<directionallight direction="-0.4 -1 -0.6" intensity="0.8" ambientIntensity="0.3"></directionallight>
<directionallight direction="0.7 -0.2 -0.6" intensity="0.4"></directionallight>
</scene></x3d>`;

const hasTag = (tag: string) => (node: ElementNode) => node.tag.toLowerCase() === tag;

export function whole(roots: readonly TreeNode[]): TreeNode[] {
  const nodes = roots.filter((node) => !isProse(node));
  if (nodes.length === 0 || [...elementsIn(roots)].some(hasTag('x3d'))) return [...roots];
  const [x3d] = (parse(STAGE) as { roots: TreeNode[] }).roots as [ElementNode];
  if (nodes.some((node) => isElement(node) && hasTag('scene')(node))) x3d.children = nodes;
  else (x3d.children[0] as ElementNode).children.push(...nodes);
  return [x3d, ...roots.filter(isProse)];
}
