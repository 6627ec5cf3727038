import type { Affine } from '../geometry/matrix.js';
import type { X3DDocument, X3DMesh, X3DNode } from '../x3dom/x3dom.js';
import type { Color, Point } from './ramp.js';

/** What a system is drawn with: where any of it is another, it is drawn anew. */
export interface Look {
  doc: X3DDocument;
  element: Element;
  /** The geometryType. */
  type: string;
  /** Metres. */
  size: [number, number];
  /** From its own frame to the world, or to the body that carries it. */
  frame: Affine;
  appearance: X3DNode | undefined;
  geometry: X3DMesh | undefined;
  /** Of the geometry. */
  points: ArrayLike<number> | undefined;
  colors: Iterable<Color> | undefined;
  colorKey: number[];
  texCoords: Iterable<Point> | undefined;
  texCoordKey: number[];
}

/** Particles in the last frame. */
export interface Shown {
  cloud: {
    count: number;
    /** PARTICLE numbers each. */
    motion: Float64Array;
    /** Seconds of their system. */
    born: Float64Array;
  };
  first: number;
  /** Seconds of their system, at the end of the last step; `since`: how long before that the frame is. */
  time: number;
  since: number;
  /** Metres of one unit of what x3dom draws. */
  length: number;
}
