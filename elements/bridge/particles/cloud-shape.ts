import { PARTICLE } from '../../../physics-core/particles.js';
import {
  x3dom,
  type NodeContext,
  type X3DMatrix,
  type X3DMesh,
  type X3DNode,
} from '../x3dom/x3dom.js';
import { Bounds } from './bounds.js';
import { formOf, type Form } from './form.js';
import type { Look, Shown } from './look.js';
import { colorsOf, texCoordsOf, type Ramp } from './ramp.js';
import { isHidden } from './hidden.js';
import { farthestFirst } from './sort.js';
import { withSortType } from './sort-type.js';

interface ShapeNode extends X3DNode {
  _dirty: Record<string, boolean>;
  _graph: { needCulling: boolean };
  renderFlag(): boolean;
  setAllDirty(): void;
}

/** An Appearance. */
interface Sorting extends X3DNode {
  /** What its author says; x3dom decides where that is `auto`. */
  _origSortType: string;
}

interface CloudMesh extends X3DMesh {
  _normals: ArrayLike<number>[];
  _texCoords: ArrayLike<number>[];
  _colors: ArrayLike<number>[];
  _numColComponents: number;
}

interface View {
  getViewMatrix(): X3DMatrix;
}

const KINDS: Record<string, string> = {
  TRIANGLES: 'IndexedTriangleSet',
  LINES: 'LineSet',
  POINTS: 'PointSet',
};

/** Of a view: right, up and back. */
const AXES = ['_00', '_01', '_02', '_10', '_11', '_12', '_20', '_21', '_22'] as const;

/** Where what is not alive stands: out of any sight, metres. */
const NOWHERE = 1e30;

/** All particles of a system in one Shape, which stands in no document: no element, so nothing meets it but x3dom. */
export class CloudShape {
  readonly #look: Look;
  readonly #form: Form;
  readonly #shape: ShapeNode;
  readonly #mesh: CloudMesh;
  readonly #looksOf: Sorting;
  readonly #bounds: Bounds;
  readonly #colors: Ramp | undefined;
  readonly #texCoords: Ramp | undefined;
  #room = 0;
  #drawn = 0;
  #shown: Shown | undefined;
  #stale = true;
  /** Right, up and back of who looks, in the world. */
  readonly #view = new Float64Array(9);

  constructor(look: Look) {
    this.#look = look;
    const x = x3dom()!;
    const { doc } = look;
    const nameSpace = doc._scene!._nameSpace!;
    const context: NodeContext = { doc, runtime: undefined, xmlNode: null, nameSpace };
    const make = (type: string): X3DNode => {
      const node = new x.nodeTypes[type](context);
      node._nameSpace = nameSpace;
      return node;
    };
    this.#form = formOf(look);
    this.#colors = look.colors && colorsOf(look.colors, look.colorKey);
    this.#texCoords =
      look.texCoords && texCoordsOf(look.texCoords, look.texCoordKey, this.#form.corners);
    this.#shape = make('Shape') as ShapeNode;
    const geometry = make(KINDS[this.#form.primitive]);
    geometry._vf.solid = false;
    this.#mesh = geometry._mesh as CloudMesh;
    this.#mesh._numColComponents = 4;
    this.#looksOf = this.#appearance(make);
    this.#shape.addChild(this.#looksOf, 'appearance');
    // What fades shows what is behind it, if its author says nothing else.
    if (this.#colors?.fades && this.#looksOf._origSortType === 'auto')
      this.#shape._cf.appearance!.node = withSortType(this.#looksOf, 'transparent');
    this.#shape.addChild(geometry, 'geometry');
    this.#shape._vf.isPickable = false;
    this.#bounds = new Bounds(this.#shape);
    this.#shape._graph.needCulling = false;
    // x3dom asks whenever it is about to draw.
    this.#shape.renderFlag = () => this.#fill();
    this.#shape.nodeChanged();
  }

  #appearance(make: (type: string) => X3DNode): Sorting {
    const given = this.#look.appearance;
    const node = given ?? make('Appearance');
    // Without that x3dom does not know when to draw it.
    if (!given) node.nodeChanged();
    return node as Sorting;
  }

  looks(look: Look): boolean {
    const own = this.#look as unknown as Record<string, unknown>;
    return Object.entries(look).every(
      ([name, value]) =>
        value === own[name] || (Array.isArray(value) && String(value) === String(own[name])),
    );
  }

  /** Shows particles as they are now, when x3dom draws next. */
  show(shown: Shown): void {
    this.#shown = shown;
    this.#stale = true;
    const { _scene: scene } = this.#look.doc;
    const any = shown.cloud.count > shown.first;
    // x3dom takes no shape that never had anything to draw.
    if (any && this.#shape._parentNodes.length === 0) {
      this.#fill();
      scene!.addChild(this.#shape);
    }
    if (any || this.#drawn > 0) this.#look.doc.needRender = true;
  }

  remove(): void {
    const { doc } = this.#look;
    this.#shape._cf.appearance!.node = this.#looksOf;
    this.#shape.removeChild(this.#looksOf);
    if (this.#shape._parentNodes.length > 0) doc._scene?.removeChild(this.#shape);
    doc.needRender = true;
  }

  // ---- what is drawn ----------------------------------------------------------------------------------------------

  #fill(): boolean {
    const shown = this.#shown;
    if (!shown) return false;
    const turned = this.#turnView();
    if (!this.#stale && !(turned && (this.#form.faces || this.#sorted))) return this.#visible;
    this.#stale = false;
    const count = shown.cloud.count - shown.first;
    if (count > this.#room) this.#grow(count);
    if (this.#room > 0) this.#write(shown, count);
    return this.#visible;
  }

  get #visible(): boolean {
    return this.#drawn > 0 && !isHidden(this.#look.element);
  }

  get #sorted(): boolean {
    const { _vf: values, _cf: parts } = this.#shape._cf.appearance!.node!;
    const transparency = parts.material?.node?._vf.transparency;
    return values.sortType === 'transparent' || Number(transparency) > 0;
  }

  /** Reads where the viewer looks; whether that is another way than before. */
  #turnView(): boolean {
    const { _viewarea: area } = this.#look.doc as { _viewarea?: unknown };
    const matrix = (area as View | undefined)?.getViewMatrix();
    let turned = false;
    for (let i = 0; matrix && i < 9; i++) {
      const value = matrix[AXES[i]!];
      if (value === this.#view[i]) continue;
      this.#view[i] = value;
      turned = true;
    }
    return turned;
  }

  #grow(count: number): void {
    this.#room = Math.max(16, count, Math.min(2 * this.#room, 2 * count));
    const { corners, index, normals, texCoords } = this.#form;
    const room = this.#room;
    const mesh = this.#mesh;
    mesh._positions[0] = new Float32Array(room * corners * 3).fill(NOWHERE);
    mesh._normals[0] = repeated(normals, room);
    mesh._texCoords[0] = repeated(texCoords, room);
    mesh._colors[0] = this.#colors ? new Float32Array(room * corners * 4) : [];
    const all = new Uint32Array(room * index.length);
    for (let k = 0, at = 0; k < room; k++)
      for (let i = 0; i < index.length; i++) all[at++] = index[i] + k * corners;
    mesh._indices[0] = all;
    this.#drawn = 0;
    this.#shape.setAllDirty();
  }

  #write(shown: Shown, count: number): void {
    const { corners } = this.#form;
    const { cloud, first, time, since } = shown;
    const order = this.#sorted ? farthestFirst(cloud.motion, first, count, this.#view) : undefined;
    const basis = this.#form.faces ? this.#view : undefined;
    const positions = this.#mesh._positions[0] as Float32Array;
    const colors = this.#mesh._colors[0] as Float32Array;
    const texCoords = this.#mesh._texCoords[0] as Float32Array;
    let drawn = 0;
    this.#bounds.begin();
    for (let i = 0; i < count; i++) {
      const k = order ? order[i]! : first + i;
      const age = time - cloud.born[k]! - since;
      // It is born after this frame.
      if (age < 0) continue;
      this.#form.place(cloud.motion, k * PARTICLE, shown, basis, positions, drawn * corners * 3);
      this.#colors?.write(age, colors, drawn * corners * 4, corners);
      this.#texCoords?.write(age, texCoords, drawn * corners * 2, corners);
      this.#bounds.add(positions, drawn * corners * 3);
      drawn++;
    }
    this.#bounds.end(this.#form.reach);
    const end = drawn * corners * 3;
    if (drawn < this.#drawn) positions.fill(NOWHERE, end, this.#drawn * corners * 3);
    this.#drawn = drawn;
    this.#noteDirty();
  }

  #noteDirty(): void {
    const { _dirty: dirty } = this.#shape;
    dirty.positions = true;
    if (this.#colors) dirty.colors = true;
    if (this.#texCoords) dirty.texcoords = true;
  }
}

function repeated(values: ArrayLike<number>, times: number): Float32Array {
  const out = new Float32Array(values.length * times);
  for (let k = 0; k < times; k++) out.set(values, k * values.length);
  return out;
}
