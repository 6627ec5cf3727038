import type { Affine } from '../geometry/matrix.js';
import type { X3DDocument, X3DMesh, X3DNode } from '../x3dom/x3dom.js';
import type { Color, Point } from './ramp.js';

/** What a system is drawn with. Each part is another object as soon as it says something else. */
export interface Look {
  doc: X3DDocument;
  element: Element;
  /** The geometryType. */
  type: string;
  /** Metres. */
  size: readonly number[];
  /** From its own frame to the world, or to the body that carries it. */
  frame: Affine;
  /** Metres of one unit of what x3dom draws. */
  length: number;
  appearance: X3DNode | undefined;
  geometry: X3DMesh | undefined;
  /** Of the geometry. */
  points: ArrayLike<number> | undefined;
  colors: Iterable<Color> | undefined;
  colorKey: readonly number[];
  texCoords: Iterable<Point> | undefined;
  texCoordKey: readonly number[];
}

/** Where any of these is another, the Shape is. */
const OF_SHAPE = [
  ...(['doc', 'element', 'type', 'length', 'appearance', 'geometry', 'points'] as const),
  ...(['colors', 'colorKey', 'texCoords', 'texCoordKey'] as const),
];

/** Where any of these is, one particle is. */
const OF_FORM = ['size', 'frame'] as const;

const alike = (a: Look, b: Look, names: readonly (keyof Look)[]): boolean => {
  for (const name of names) if (a[name] !== b[name]) return false;
  return true;
};

export const sameShape = (a: Look, b: Look): boolean => alike(a, b, OF_SHAPE);
export const sameForm = (a: Look, b: Look): boolean => alike(a, b, OF_FORM);
