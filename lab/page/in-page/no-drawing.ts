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

/** From now on nothing is drawn; scripts notice nothing of it. */
export function drawNothing(): void {
  for (const { prototype } of [WebGLRenderingContext, WebGL2RenderingContext])
    for (const name of WORKS) if (name in prototype) (prototype as any)[name] = () => {};
}
