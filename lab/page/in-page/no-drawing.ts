/** What makes a graphics card work. Without one the processor does, and a frame waits for that. */
const WORKS = [
  'blitFramebuffer',
  'clear',
  'clearBufferfv',
  'drawArrays',
  'drawArraysInstanced',
  'drawBuffers',
  'drawElements',
  'drawElementsInstanced',
  'drawRangeElements',
  'finish',
  'flush',
  'generateMipmap',
  'readPixels',
];

/** The browser draws the page for each of their frames: X_ITE leaves a spinner on for ever, unseen. */
function stopAnimations(root: Document | ShadowRoot): void {
  for (const animation of root.getAnimations()) animation.cancel();
  for (const { shadowRoot } of root.querySelectorAll('*'))
    if (shadowRoot) stopAnimations(shadowRoot);
}

/** From now on nothing is drawn; scripts notice nothing of it. */
export function drawNothing(): void {
  stopAnimations(document);
  for (const { prototype } of [WebGLRenderingContext, WebGL2RenderingContext])
    for (const name of WORKS) if (name in prototype) (prototype as any)[name] = () => {};
}
