/**
 * A physics element that no scene will ever see: outside any `<x3d>`, or in a shadow root, where x3dom does not look.
 * There is no world to tell, so the console and the event are all.
 */
export function checkPlace(element: Element): void {
  if (!element.isConnected) return;
  const inScene = element.closest('x3d, X3D') && element.closest('scene, Scene');
  const inShadow = element.getRootNode() instanceof ShadowRoot;
  if (inScene && !inShadow) return;
  const [code, message] = inShadow
    ? ['shadow-root', `<${element.localName}> stands in a shadow root, where x3dom does not look`]
    : ['misplaced', `<${element.localName}> stands outside the scene of any <x3d>`];
  console.warn(`x3d-physics: ${message} [${code}]`);
  const detail = { code, severity: 'warning', message, element };
  element.dispatchEvent(
    new CustomEvent('physicsproblem', { bubbles: true, composed: true, detail }),
  );
}
