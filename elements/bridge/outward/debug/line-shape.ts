import type { DebugLines } from '../../../../physics-core/inside.js';
import {
  x3dom,
  type NodeContext,
  type X3DDocument,
  type X3DMesh,
  type X3DNode,
  type X3DOM,
} from '../../x3dom/x3dom.js';

/** What x3dom's Shape has beside what all its nodes have. */
interface ShapeNode extends X3DNode {
  _dirty: Record<string, boolean>;
  _graph: { needCulling: boolean };
  renderFlag(): boolean;
}

interface LineMesh extends X3DMesh {
  _colors: ArrayLike<number>[];
  _numColComponents: number;
}

/** Drawn after everything else. */
const LAST = 1_000_000;

/**
 * A Shape of lines that x3dom draws, but that stands in no document: no element, so no script, ROUTE, pick or observer
 * meets it, and nobody takes it for geometry. It is seen through what stands before it, and takes no part in the bounds
 * of the scene.
 */
export class LineShape {
  readonly #scene: X3DNode;
  readonly #shape: ShapeNode;
  readonly #mesh: LineMesh;
  #index = new Uint32Array(0);
  #shown = 0;

  constructor(document: X3DDocument) {
    const x = x3dom()!;
    this.#scene = document._scene!;
    const make = maker(x, document);
    this.#shape = make('Shape') as ShapeNode;
    const geometry = make('LineSet');
    this.#mesh = geometry._mesh as LineMesh;
    this.#mesh._numColComponents = 3;
    this.#shape.addChild(appearance(make), 'appearance');
    this.#shape.addChild(geometry, 'geometry');
    this.#shape._vf.isPickable = false;
    // Its bounds are empty, and what is empty would be left out as out of sight.
    const nowhere = new x.fields.BoxVolume();
    this.#shape.getVolume = () => nowhere;
    this.#shape._graph.needCulling = false;
    this.#shape.renderFlag = () => this.#shown > 0;
  }

  /** Shows lines as they stand now. */
  show({ positions, colors, count }: DebugLines): void {
    if (this.#index.length < 2 * count) this.#index = upTo(positions.length / 3);
    const mesh = this.#mesh;
    mesh._positions[0] = positions.subarray(0, 6 * count);
    mesh._colors[0] = colors.subarray(0, 6 * count);
    mesh._indices[0] = this.#index.subarray(0, 2 * count);
    const { _dirty: dirty } = this.#shape;
    dirty.positions = dirty.colors = dirty.indexes = true;
    this.#shown = count;
    // x3dom takes no shape that never had a line.
    if (count > 0 && this.#shape._parentNodes.length === 0) this.#scene.addChild(this.#shape);
  }

  remove(): void {
    if (this.#shape._parentNodes.length > 0) this.#scene.removeChild(this.#shape);
  }
}

/** Each end of each line is a point of its own. */
const upTo = (length: number): Uint32Array<ArrayBuffer> =>
  Uint32Array.from({ length }, (_, i) => i);

type Make = (type: string) => X3DNode;

function maker(x: X3DOM, doc: X3DDocument): Make {
  const nameSpace = doc._scene!._nameSpace!;
  const context: NodeContext = { doc, runtime: undefined, xmlNode: null, nameSpace };
  return (type) => {
    const node = new x.nodeTypes[type](context);
    node._nameSpace = nameSpace;
    return node;
  };
}

/** Without a depth test, so that centres of mass are seen inside bodies. */
function appearance(make: Make): X3DNode {
  const node = make('Appearance');
  const depth = make('DepthMode');
  depth._vf.enableDepthTest = false;
  node.addChild(depth, 'depthMode');
  node._vf.sortType = 'transparent';
  node._vf.sortKey = LAST;
  return node;
}
