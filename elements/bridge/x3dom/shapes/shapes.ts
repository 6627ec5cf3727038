import { Chunk, meshes } from '../../../../physics-core/inside.js';
import { lowerName } from '../../words/dom.js';
import { x3dom, type X3DOM } from '../x3dom.js';

/** Geometry that collides, and that x3dom may lack: npm's x3dom.js does. */
const SHAPES =
  /^(elevationgrid|extrusion|(indexed)?(triangle(fan|strip)|quad)set|rectangle2d|disk2d)$/;

/** What draws it, with the triangles that collide. */
export interface Shapes {
  /** Makes node types of x3dom of those that it has none of. */
  register(x: X3DOM): void;
}

/** Nobody needs it who has none of that, or an x3dom that has all of it. */
export const shapes = new Chunk<Shapes>({
  name: 'shapes',
  causes: 'geometry that x3dom lacks',
}).comesFrom(() => import('./shapes-code.js'));

/** Whether x3dom has nothing for a geometry, but we have. */
export const lacks = (element: Element): boolean => {
  const x = x3dom();
  return !!x && SHAPES.test(lowerName(element)) && !x.nodeTypesLC[lowerName(element)];
};

let failed = false;

/** What draws it can't be had: what collides stays unseen. */
export const cannotDraw = (element: Element): boolean => failed && lacks(element);

/** Waits for what draws it, and has x3dom know. */
export async function learnShapes(): Promise<void> {
  try {
    await Promise.all([shapes.load(), meshes.load()]);
    shapes.code.register(x3dom()!);
  } catch {
    failed = true;
  }
}
