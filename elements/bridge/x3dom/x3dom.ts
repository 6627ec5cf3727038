import type { X3DProgram } from './renderer.js';

/** The slice of x3dom 1.8.3 that the bridge uses. x3dom has no types and is a classic script of the page. */

export interface X3DMatrix {
  _00: number;
  _01: number;
  _02: number;
  _03: number;
  _10: number;
  _11: number;
  _12: number;
  _13: number;
  _20: number;
  _21: number;
  _22: number;
  _23: number;
  _30: number;
  _31: number;
  _32: number;
  _33: number;
  mult(other: X3DMatrix): X3DMatrix;
}

export interface X3DVector {
  x: number;
  y: number;
  z: number;
}

export interface X3DQuaternion extends X3DVector {
  w: number;
}

export interface X3DMesh {
  _primType: string;
  _positions: ArrayLike<number>[];
  _indices: ArrayLike<number>[];
}

export interface X3DMeshClass {
  new (geometry: X3DNode): X3DMesh & { _vol: object };
}

export interface X3DNode {
  _xmlNode: Element | null;
  _DEF: string | null;
  _nameSpace: NameSpace | null;
  _vf: Record<string, unknown>;
  _cf: Record<string, { node?: X3DNode | null; nodes?: X3DNode[] }>;
  _cfFieldTypes: Record<string, string>;
  _fieldWatchers: Record<string, unknown[]>;
  _routes: Record<string, unknown>;
  _listeners: Record<string, unknown[]>;
  _parentNodes: X3DNode[];
  _childNodes: X3DNode[];
  /** Transforms only. */
  _trafo?: X3DMatrix;
  /** Geometry only. */
  _mesh?: X3DMesh;
  /** Geometry that we draw: the triangles that collide. */
  surface?: { points: number[]; index: number[] };
  /** Instances of prototypes only. */
  protoBodyClone?: Element;
  addChild(child: X3DNode, containerField?: string | null): boolean | undefined;
  postMessage(field: string, value: unknown): void;
  fieldChanged(field: string): void;
  nodeChanged(field?: string): void;
  updateField(attribute: string, text: string): void;
  setupRoute(field: string, to: X3DNode, toField: string): void;
  removeRoute(field: string, to: X3DNode, toField: string): void;
  invalidateVolume(): void;
  getVolume(): unknown;
  removeChild(child: X3DNode, ...rest: unknown[]): boolean;
}

/** What our nodes have beside x3dom's own. */
export interface PhysicsX3DNode extends X3DNode {
  readonly element: Element | null;
  /** Sends an output to whatever is ROUTEd from it. */
  emit(field: string, value: unknown): void;
  /** The fields that something is ROUTEd from, or that somebody listens to. */
  readonly routedFields: readonly string[];
  /** A ROUTE leads from it to a node of ours. */
  feedsPhysics?: boolean;
}

export interface NameSpace {
  doc: X3DDocument;
  superInlineNode: X3DNode | null;
  defMap: Record<string, X3DNode | undefined>;
  setupTree(node: Node, parent: X3DNode | null): X3DNode | null;
  routeLateRoutes(): void;
}

/** A projection, or its inverse. */
export interface X3DProjection {
  multFullMatrixPnt(point: X3DVector): X3DVector;
}

export interface X3DViewarea {
  _lastButton: number;
  _pressX: number;
  /** From the scene to the picture, each of x, y, z from -1 to 1, and back. */
  getWCtoCCMatrix(): X3DProjection;
  getCCtoWCMatrix(): X3DProjection;
}

export interface X3DDocument {
  _viewarea?: X3DViewarea;
  needRender: boolean | number;
  _scene: X3DNode | null;
  onNodeAdded(element: Element, parent: Element): void;
  onNodeRemoved(element: Element, parent: Element): void;
}

export interface NodeContext {
  doc: X3DDocument;
  runtime: unknown;
  xmlNode: Element | null;
  nameSpace: NameSpace;
}

export interface X3DNodeClass {
  new (context: NodeContext): X3DNode;
  prototype: X3DNode;
  _typeName?: string;
}

export interface X3DElement extends Element {
  _x3domNode?: X3DNode;
  hasRuntime?: boolean;
  runtime?: {
    canvas?: { canvas?: HTMLCanvasElement; doc?: X3DDocument | null } | null;
    /** What it measures of the last picture, milliseconds. */
    states?: { measurements: Record<string, number> };
  } | null;
}

export interface X3DOM {
  /** Where the buffers of a Shape stand in its list of them. */
  BUFFER_IDX: Record<string, number>;
  nodeTypes: Record<string, X3DNodeClass>;
  nodeTypesLC: Record<string, X3DNodeClass>;
  /** Node types of each component. */
  components: Record<string, Record<string, X3DNodeClass> | undefined>;
  caps: Record<string, unknown>;
  Mesh: X3DMeshClass;
  NodeNameSpace: { prototype: NameSpace };
  X3DDocument: { prototype: X3DDocument };
  fields: {
    SFVec3f: new (x: number, y: number, z: number) => X3DVector;
    SFVec2f: new (x: number, y: number) => { x: number; y: number };
    SFMatrix4f: { new (): X3DMatrix; identity(): X3DMatrix; scale(by: X3DVector): X3DMatrix };
    /** Empty as long as it is given no corners. */
    BoxVolume: new () => object;
    Quaternion: {
      new (x: number, y: number, z: number, w: number): X3DQuaternion;
      axisAngle(axis: X3DVector, angle: number): X3DQuaternion;
    };
    MFVec3f: new (array?: unknown[]) => unknown[];
    MFString: new (array?: unknown[]) => unknown[];
    MFFloat: new (array?: unknown[]) => unknown[];
  };
  Utils: {
    /** With a setter for each uniform. */
    wrapProgram(gl: WebGLRenderingContext, program: WebGLProgram, id: string): X3DProgram;
  };
  /** Shaders and textures of one canvas. */
  Cache: { prototype: { Release(gl: WebGLRenderingContext): void } };
  registerNodeType(name: string, component: string, type: X3DNodeClass): void;
  reload(): void;
}

declare const globalThis: { x3dom?: X3DOM };

/** x3dom, once the page has it. */
export const x3dom = (): X3DOM | undefined => globalThis.x3dom;

export const nodeOf = (element: Element): X3DNode | undefined => (element as X3DElement)._x3domNode;

/** The document behind an `<x3d>`, once x3dom has read it. */
export function documentOf(x3d: Element): X3DDocument | undefined {
  const doc = (x3d as X3DElement).runtime?.canvas?.doc;
  return doc?._scene ? doc : undefined;
}
