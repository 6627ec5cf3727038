// How a scene looks when it begins, light and dark: no face is black, no body is cut off, each stands out from what is behind it.
import type { Browser, Page as Tab } from 'playwright';
import { decoder, distance, type Picture } from './picture.js';
import type { Scene } from './sources.js';

/** Pixels of a page's column of text, and of a frame whose scene does not say how high. */
const WIDTH = 688;
const HEIGHT = 340;

/** Of 255: what no channel exceeds is black. */
const BLACK = 20;
/** Share of a picture that may be. */
const BLACK_SHARE = 0.005;

/** How far a body's colour is from that behind it: of the 441 between black and white. */
const CONTRAST = 40;
/** Of the bodies' shapes, those that may be hidden by something, or be cut off where a crowd comes in from above. */
const EXCEPTIONS = 0.1;

/** Where a shape is in the picture: from -1 to 1, rightwards and upwards. */
interface Place {
  name: string;
  left: number;
  right: number;
  bottom: number;
  top: number;
}

/** Runs in the page: the worlds stand where they began, and what of bodies that move is drawn where. */
const START = (library: string): string => `(async () => {
  const { explain, worldOf } = globalThis.X3DPhysics ?? await import('${library}');
  const all = [...document.querySelectorAll('x3d *')];
  const worlds = new Set(all.map(worldOf).filter(Boolean));
  await Promise.all([...worlds].map(({ ready }) => ready));
  for (const world of worlds) {
    world.paused = true;
    world.reset();
  }
  const moves = (element) => {
    const { type, fields } = explain(element);
    return /^(RigidBody|CollidableShape)$/.test(type) && !fields.fixed;
  };
  globalThis.moving = all.filter((element) => element._x3domNode?._cf?.geometry && moves(element));
})()`;

/** Two frames: x3dom draws in one what is asked for before it. */
const DRAWN = `(async () => {
  const { doc } = document.querySelector('x3d').runtime.canvas;
  for (let i = 0; i < 3; i++) {
    doc.needRender = 1;
    await new Promise(requestAnimationFrame);
  }
})()`;

const PLACES = `(() => {
  const view = document.querySelector('x3d').runtime.canvas.doc._viewarea.getWCtoCCMatrix();
  const { SFVec3f } = x3dom.fields;
  return moving.map((element) => {
    const node = element._x3domNode;
    const { min, max } = node.getVolume();
    const matrix = view.mult(node.getCurrentTransform());
    const corners = Array.from({ length: 8 }, (_, i) =>
      matrix.multFullMatrixPnt(new SFVec3f(...['x', 'y', 'z'].map((axis, k) => (i >> k & 1 ? max : min)[axis]))));
    const [xs, ys] = ['x', 'y'].map((axis) => corners.map((corner) => corner[axis]));
    const name = element.closest('[title]')?.title || element.querySelector('box, sphere, cylinder, cone')?.localName || 'shape';
    return { name, left: Math.min(...xs), right: Math.max(...xs), bottom: Math.min(...ys), top: Math.max(...ys) };
  });
})()`;
