import type { ProblemReport } from '../../../physics-core/inside.js';
import { setState } from '../base/states.js';
import { logInPage } from '../words/console.js';
import { faultsFor } from '../words/faults.js';

const misplaced = new WeakSet<Element>();
const told = new WeakMap<Element, Set<string>>();

/** Of an element that no world has: the console and the event are all. */
export function tellPage(report: ProblemReport, element: Element): void {
  const key = `${report.code} ${report.attribute}`;
  const before = told.get(element) ?? new Set();
  if (before.has(key)) return;
  told.set(element, before.add(key));
  logInPage(report, element);
  setState(element, 'problem', true);
  const detail = { ...report, element };
  element.dispatchEvent(
    new CustomEvent('physicsproblem', { bubbles: true, composed: true, detail }),
  );
}

/** Nodes of x3dom's that hold none: they stand around one of ours where the author thought them closed. Metadata may. */
const LEAVES =
  'viewpoint, navigationinfo, background, directionallight, pointlight, spotlight, box, sphere, cylinder, cone';

/**
 * A physics element that no scene will ever see: outside any `<x3d>`, in a shadow root, where x3dom does not look, or
 * swallowed.
 */
export function checkPlace(element: Element): void {
  if (!element.isConnected) return;
  if (misplaced.delete(element)) {
    told.delete(element);
    setState(element, 'problem', false);
  }
  const inScene = element.closest('x3d, X3D') && element.closest('scene, Scene');
  const inShadow = element.getRootNode() instanceof ShadowRoot;
  const leaf = element.closest(LEAVES);
  if (inScene && !inShadow && !leaf) return;
  misplaced.add(element);
  const faults = faultsFor(element, () => checkPlace(element));
  if (!faults) return;
  if (leaf) tellPage(faults.swallowed(leaf, element), leaf);
  else tellPage(faults.outside(element, inShadow), element);
}
