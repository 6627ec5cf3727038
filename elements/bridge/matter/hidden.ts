import { nodeOf, type X3DNode } from '../x3dom/x3dom.js';

/** Whether x3dom would not draw what stands there: it, or what it is in, is not rendered, or not chosen by its Switch. */
export function isHidden(element: Element): boolean {
  let below: X3DNode | undefined;
  for (let at = nodeOf(element); at; below = at, at = at._parentNodes[0]) {
    const { render, visible, whichChoice } = at._vf;
    if (render === false || visible === false) return true;
    if (below && whichChoice !== undefined && at._childNodes[whichChoice as number] !== below)
      return true;
  }
  return says(element, 'render') || says(element, 'visible');
}

/** Also what x3dom knows no field for. */
const says = (element: Element, name: string): boolean =>
  Element.prototype.getAttribute.call(element, name)?.trim().toLowerCase() === 'false';
