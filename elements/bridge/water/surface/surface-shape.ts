import type { ShownSurface } from '../../../../physics-core/water.js';
import type { X3DDrawnDocument } from '../../x3dom/renderer.js';
import {
  x3dom,
  type NodeContext,
  type X3DDocument,
  type X3DMesh,
  type X3DNode,
} from '../../x3dom/x3dom.js';
import { SurfaceMesh, type Place } from './mesh.js';

interface ShapeNode extends X3DNode {
  _dirty: Record<string, boolean>;
  _webgl?: { buffers: (WebGLBuffer | undefined)[] };
  _graph: { needCulling: boolean };
  renderFlag(): boolean;
}

interface Mesh extends X3DMesh {
  _normals: ArrayLike<number>[];
  _texCoords: ArrayLike<number>[];
}

/** The surface of a volume in a Shape of its own, which stands in no document, and is drawn as the author's is, instead of it. */
export class SurfaceShape {
  readonly doc: X3DDocument;
  /** The author's. */
  readonly instead: ShapeNode;
  readonly #appearance: X3DNode;
  readonly #shape: ShapeNode;
  readonly #geometry: Mesh;
  #mesh: SurfaceMesh | undefined;
  #cells = 0;
  #version = -1;
  #place = '';
  /** Asks the author's Shape whether it is to be seen. */
  readonly #seen: () => boolean;

  constructor(instead: X3DNode, appearance: X3DNode) {
    const x = x3dom()!;
    const nameSpace = instead._nameSpace!;
    this.doc = nameSpace.doc;
    this.instead = instead as ShapeNode;
    this.#appearance = appearance;
    const context: NodeContext = {
      doc: this.doc,
      runtime: undefined,
      xmlNode: null,
      nameSpace,
    };
    const make = (type: string): X3DNode => {
      const node = new x.nodeTypes[type](context);
      node._nameSpace = nameSpace;
      return node;
    };
    const geometry = make('IndexedTriangleSet');
    geometry._vf.solid = false;
    this.#geometry = geometry._mesh as Mesh;
    this.#shape = make('Shape') as ShapeNode;
    this.#shape.addChild(appearance, 'appearance');
    this.#shape.addChild(geometry, 'geometry');
    this.#shape._vf.isPickable = false;
    this.#shape._graph.needCulling = false;
    // It is as large as the author's, but for its waves.
    const volume = new x.fields.BoxVolume();
    this.#shape.getVolume = () => volume;
    const { instead: shape } = this;
    const seen = shape.renderFlag.bind(shape);
    this.#seen = seen;
    shape.renderFlag = () => false;
    this.#shape.renderFlag = () => seen();
    this.#shape.nodeChanged();
  }

  /** Whether what it is drawn with is still that. */
  wears(instead: X3DNode, appearance: X3DNode): boolean {
    return instead === this.instead && appearance === this.#appearance;
  }

  show(shown: ShownSurface, place: Place): void {
    const where = `${place.axes.join()} ${place.middle.join()} ${place.depth} ${place.unit}`;
    if (this.#version === shown.version && this.#place === where) return;
    this.#version = shown.version;
    this.#place = where;
    const cells = shown.columns * 1024 + shown.rows;
    if (cells !== this.#cells) this.#grow(shown);
    this.#cells = cells;
    this.#mesh!.write(shown, place);
    this.#upload('POSITION', 'positions', this.#mesh!.positions);
    this.#upload('NORMAL', 'normals', this.#mesh!.normals);
    const scene = this.doc._scene!;
    if (this.#shape._parentNodes.length === 0) scene.addChild(this.#shape);
    this.doc.needRender = true;
  }

  #grow(shown: ShownSurface): void {
    const mesh = new SurfaceMesh(shown);
    this.#mesh = mesh;
    this.#geometry._positions[0] = mesh.positions;
    this.#geometry._normals[0] = mesh.normals;
    this.#geometry._texCoords[0] = mesh.texCoords;
    this.#geometry._indices[0] = mesh.index;
    const { _dirty: dirty } = this.#shape;
    for (const part of Object.keys(dirty)) dirty[part] = true;
  }

  /** Into the buffer that x3dom has for it: told that a list has changed, x3dom would make that and the index anew. */
  #upload(buffer: string, list: string, numbers: Float32Array): void {
    const gl = (this.doc as X3DDrawnDocument).ctx?.ctx3d;
    const there = this.#shape._webgl?.buffers[x3dom()!.BUFFER_IDX[buffer]!];
    const { positions, indexes } = this.#shape._dirty;
    if (!gl || !there || positions || indexes) {
      this.#shape._dirty[list] = true;
      return;
    }
    gl.bindBuffer(gl.ARRAY_BUFFER, there);
    gl.bufferSubData(gl.ARRAY_BUFFER, 0, numbers);
  }

  remove(): void {
    this.instead.renderFlag = this.#seen;
    this.#shape.removeChild(this.#appearance);
    if (this.#shape._parentNodes.length > 0) this.doc._scene?.removeChild(this.#shape);
    this.doc.needRender = true;
  }
}
