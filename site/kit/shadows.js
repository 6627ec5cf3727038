// Shadows where a graphics card draws them. Without one X3DOM takes several times as long for a picture with them, and the
// motion would stutter: there no light casts any.
const { document, MutationObserver } = globalThis;

/** In XHTML a name keeps its capitals. */
const CASTS = '[shadowintensity], [shadowIntensity]';

/** Names of what draws WebGL on the processor. */
const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;

let bySoftware;

function drawnBySoftware() {
  const gl = document.createElement('canvas').getContext('webgl');
  const info = gl?.getExtension('WEBGL_debug_renderer_info');
  const name = gl?.getParameter(info?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER);
  gl?.getExtension('WEBGL_lose_context')?.loseContext();
  return SOFTWARE.test(name);
}

function spare(node) {
  const lights = [...(node.querySelectorAll?.(CASTS) ?? [])];
  if (node.matches?.(CASTS)) lights.push(node);
  if (lights.length === 0 || !(bySoftware ??= drawnBySoftware())) return;
  for (const light of lights) light.setAttribute('shadowIntensity', '0');
}

spare(document);
// What comes later: X3DOM's own observer, which is younger, reads it after this one.
new MutationObserver((records) => {
  for (const { addedNodes } of records) addedNodes.forEach(spare);
}).observe(document, { childList: true, subtree: true });
