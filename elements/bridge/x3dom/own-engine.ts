import type { X3DOM } from './x3dom.js';

// x3dom-physics.js (up to 1.7: x3dom-full.js) has an engine of its own, one for the whole page: `window.onload` reads the
// nodes of its types, gives the scene handles for the mouse, and asks for the first of its frames; each asks for the next by
// `requestAnimFrame`, which is x3dom's and which it looks up anew. Its node types give way to ours by being registered again.

interface Frames {
  requestAnimFrame?: (callback: () => void, ...rest: unknown[]) => unknown;
}

/** A global of the engine, and a property: whatever makes its code small leaves these names as they are. */
const BEGINS = /\bCreateInteractiveObjects\b/;
const FRAME = /\brequestAnimFrame\b[^]*\breadyState\b/;

/** The engine's node types. */
export type OwnTypes = ReadonlySet<unknown>;

/** To be called before our node types are registered; undefined where x3dom has no engine. */
export function stopOwnEngine(x: X3DOM): OwnTypes | undefined {
  const types = x.components.RigidBodyPhysics;
  if (!types) return undefined;
  // A handler that the page put in its place is the page's.
  const waits = window.onload !== null && BEGINS.test(String(window.onload));
  if (waits) window.onload = null;
  if (!waits || document.readyState === 'complete') refuseFrame(window as Frames);
  return new Set(Object.values(types));
}

/** It may run already, or be begun by a handler of the page's. */
function refuseFrame(frames: Frames): void {
  const request = frames.requestAnimFrame;
  if (!request) return;
  frames.requestAnimFrame = (callback, ...rest) => {
    if (!FRAME.test(String(callback))) return request.call(window, callback, ...rest);
    frames.requestAnimFrame = request;
    return undefined;
  };
}
