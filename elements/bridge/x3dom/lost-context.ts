import type { X3DOM } from './x3dom.js';

/**
 * When an `<x3d>` leaves the page x3dom takes its shaders apart. With a lost WebGL context (the graphics card was reset,
 * or the page has more contexts than the browser keeps) there are none, and it would throw halfway, then and at each
 * later removal.
 */
export function surviveLostContext(x: X3DOM): void {
  const { prototype } = x.Cache;
  const { Release } = prototype;
  prototype.Release = function (gl) {
    if (!gl.isContextLost()) Release.call(this, gl);
  };
}
