import type { X3DDocument, X3DMatrix, X3DNode, X3DVector } from './x3dom.js';

// The slice of x3dom's renderer that batched drawing uses: types alone.

export interface X3DVolume {
  min: X3DVector;
  max: X3DVector;
  center: X3DVector;
  radialVec: X3DVector;
  diameter: number;
  valid: boolean;
  transform(matrix: X3DMatrix): void;
  extendBounds(min: X3DVector, max: X3DVector): void;
}

/** Grouping nodes, Transforms and Shapes: what x3dom passes on its way to what it draws. */
export interface X3DBounded extends X3DNode {
  _graph: { needCulling: boolean; globalMatrix: X3DMatrix | null; volume: X3DVolume };
  renderFlag(): boolean;
  volumeValid(): boolean;
  getVolume(): X3DVolume;
  collectDrawableObjects(...way: Way): unknown;
  doIntersect(line: unknown): boolean;
}

export interface X3DTransform extends X3DBounded {
  _trafo: X3DMatrix;
  tick(time: number): boolean;
}

/** Matrix, what is collected, and four things more that are handed down as they are. */
export type Way = [
  matrix: X3DMatrix,
  collection: { smallFeatureThreshold: number; viewarea: unknown },
  ...rest: unknown[],
];

export interface X3DShape extends X3DBounded {
  _objectID: number;
  _webgl?: { shader: X3DProgram; buffers: (WebGLBuffer | undefined)[] };
  _shaderProperties: unknown;
  /** Made with what x3dom keeps in WebGL. */
  _cleanupGLObjects: ((always: boolean) => void) | null;
  /** What is not yet in WebGL as the fields have it. */
  _dirty: Record<string, boolean>;
  getShaderProperties(viewarea: unknown): unknown;
  unsetDirty(): void;
}

export interface X3DColor {
  r: number;
  g: number;
  b: number;
}

/** A linked program with a setter for each of its uniforms. */
export interface X3DProgram {
  shaderID: string;
  program: WebGLProgram;
}

export interface X3DShaderCache {
  shaders: Record<string, X3DProgram>;
  getShaderByProperties(
    gl: WebGL2RenderingContext,
    shape: X3DNode,
    properties: unknown,
    pickMode?: number | null,
    shadows?: boolean | null,
  ): X3DProgram | undefined;
}

/** What draws one `<x3d>`. */
export interface X3DRenderer {
  ctx3d: WebGL2RenderingContext;
  cache: X3DShaderCache;
  /** How many pictures it draws of everything: two where somebody wears glasses. */
  VRMode: number;
  renderScene(...args: unknown[]): void;
  renderShape(
    drawable: unknown,
    area: unknown,
    lights: unknown,
    count: number,
    view: X3DMatrix,
    scene: X3DMatrix,
    ...rest: unknown[]
  ): void;
  renderShadowPass(
    gl: WebGL2RenderingContext,
    area: unknown,
    scene: X3DMatrix,
    view: X3DMatrix,
    ...rest: unknown[]
  ): void;
  renderPickingPass(
    gl: WebGL2RenderingContext,
    all: unknown,
    view: X3DMatrix,
    scene: X3DMatrix,
    ...rest: unknown[]
  ): void;
  drawElements(
    gl: WebGL2RenderingContext,
    mode: number,
    count: number,
    type: number,
    offset: number,
    instances?: number,
  ): void;
  drawArrays(
    gl: WebGL2RenderingContext,
    mode: number,
    first: number,
    count: number,
    instances?: number,
  ): void;
  setVertexAttribPointerPosition(
    gl: WebGL2RenderingContext,
    shape: X3DNode,
    ...rest: unknown[]
  ): void;
}

/** A document that is drawn. */
export interface X3DDrawnDocument extends X3DDocument {
  ctx: X3DRenderer;
  _nodeBag: { renderTextures: unknown[]; trans: { tick(time: number): boolean }[] };
}
