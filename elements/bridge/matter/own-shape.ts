import {
  x3dom,
  type NodeContext,
  type X3DDocument,
  type X3DMesh,
  type X3DNode,
} from '../x3dom/x3dom.js';
import { isHidden } from './hidden.js';
import { upload, type UploadedShape } from './upload.js';

interface ShapeNode extends UploadedShape {
  _graph: { needCulling: boolean };
  renderFlag(): boolean;
}

export interface OwnMesh extends X3DMesh {
  _normals: ArrayLike<number>[];
  _texCoords: ArrayLike<number>[];
}

/** A geometry of ours in a Shape of its own, which stands in no document, and is drawn as the author's is, instead of it. */
export class OwnShape {
  readonly doc: X3DDocument;
  /** The author's. */
  readonly instead: ShapeNode;
  readonly #appearance: X3DNode;
  protected readonly shape: ShapeNode;
  protected readonly mesh: OwnMesh;
  /** Asks the author's Shape whether it is to be seen. */
  readonly #seen: () => boolean;

  constructor(instead: X3DNode, appearance: X3DNode, type: 'IndexedTriangleSet' | 'LineSet') {
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
    const make = (name: string): X3DNode => {
      const node = new x.nodeTypes[name](context);
      node._nameSpace = nameSpace;
      return node;
    };
    const geometry = make(type);
    geometry._vf.solid = false;
    this.mesh = geometry._mesh as OwnMesh;
    this.shape = make('Shape') as ShapeNode;
    this.shape.addChild(appearance, 'appearance');
    this.shape.addChild(geometry, 'geometry');
    this.shape._vf.isPickable = false;
    this.shape._graph.needCulling = false;
    const { instead: shape } = this;
    const seen = shape.renderFlag.bind(shape);
    this.#seen = seen;
    shape.renderFlag = () => false;
    this.shape.renderFlag = () => seen() && !this.hidden;
    this.shape.nodeChanged();
  }

  /** Where the author's is not drawn, this is not. */
  protected get hidden(): boolean {
    return isHidden(this.instead._xmlNode!);
  }

  /** Whether what it is drawn with is still that. */
  wears(instead: X3DNode, appearance: X3DNode): boolean {
    return instead === this.instead && appearance === this.#appearance;
  }

  /** The lists of its mesh are others. */
  protected remake(): void {
    const { _dirty: dirty } = this.shape;
    for (const part of Object.keys(dirty)) dirty[part] = true;
  }

  protected upload(buffer: Parameters<typeof upload>[2], numbers: Float32Array): void {
    upload(this.shape, this.doc, buffer, numbers);
  }

  /** From now on, and anew. */
  protected draw(): void {
    if (this.shape._parentNodes.length === 0) this.doc._scene!.addChild(this.shape);
    this.doc.needRender = true;
  }

  remove(): void {
    this.instead.renderFlag = this.#seen;
    this.shape.removeChild(this.#appearance);
    if (this.shape._parentNodes.length > 0) this.doc._scene?.removeChild(this.shape);
    this.doc.needRender = true;
  }
}
