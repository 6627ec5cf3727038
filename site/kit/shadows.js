// Shadows where a graphics card draws them. Without one X3DOM takes several times as long for a picture with them, and the
// motion would stutter: there no light casts any.
const { document } = globalThis;

/** Names of what draws WebGL on the processor. */
const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;

function drawnBySoftware() {
  const gl = document.createElement('canvas').getContext('webgl');
  const info = gl?.getExtension('WEBGL_debug_renderer_info');
  const name = gl?.getParameter(info?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER);
  gl?.getExtension('WEBGL_lose_context')?.loseContext();
  return SOFTWARE.test(name);
}

/** Of markup that stands in the page, or that a script is about to put there. */
export function spareShadows(root) {
  // In XHTML a name keeps its capitals.
  const lights = root.querySelectorAll('[shadowintensity], [shadowIntensity]');
  if (lights.length === 0 || !drawnBySoftware()) return;
  for (const light of lights) light.setAttribute('shadowIntensity', '0');
}

spareShadows(document);
