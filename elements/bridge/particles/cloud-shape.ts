import type { Shown } from '../../../physics-core/particles.js';
import { x3dom, type NodeContext, type X3DMatrix, type X3DNode } from '../x3dom/x3dom.js';
import { Bounds } from '../matter/bounds.js';
import { fading } from './fading.js';
import type { Form } from './form.js';
import { formOf } from './forms.js';
import { isHidden } from '../matter/hidden.js';
import { sameForm, sameShape, type Look } from './look.js';
import { colorsOf, texCoordsOf, type Ramp } from './ramp.js';
import { makeRoom, NOWHERE, spread, type CloudMesh } from './room.js';
import { Seen } from './seen.js';
import { farthestFirst } from './sort.js';
import { upload, type UploadedShape } from '../matter/upload.js';

interface ShapeNode extends UploadedShape {
  _graph: { needCulling: boolean };
  renderFlag(): boolean;
}

/** An Appearance. */
interface Sorting extends X3DNode {
  /** What its author says; x3dom decides where that is `auto`. */
  _origSortType: string;
}

interface View {
  getViewMatrix(): X3DMatrix;
}

const KINDS: Record<string, string> = {
  TRIANGLES: 'IndexedTriangleSet',
  LINES: 'LineSet',
  POINTS: 'PointSet',
};

/** Room for so many times those that are seen: seldom made anew, and x3dom draws all of it in each frame. */
const GROWTH = 1.25;

/** Of a view: right, up and back. */
const AXES = ['_00', '_01', '_02', '_10', '_11', '_12', '_20', '_21', '_22'] as const;

/** All particles of a system in one Shape, which stands in no document: no element, so nothing meets it but x3dom. */
export class CloudShape {
  #look: Look;
  #form: Form;
  readonly #shape: ShapeNode;
  readonly #mesh: CloudMesh;
  readonly #looksOf: Sorting;
  readonly #bounds: Bounds;
  readonly #colors: Ramp | undefined;
  readonly #texCoords: Ramp | undefined;
  readonly #seen = new Seen();
  #room = 0;
  #drawn = 0;
  #stale = true;
  /** Right, up and back of who looks, in the world. */
  readonly #view = new Float64Array(9);

  constructor(look: Look) {
    this.#look = { ...look };
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
    const { corners, texCoords } = this.#form;
    // Points, and geometry that is no texture's, have no room for any.
    if (look.texCoords && texCoords.length === 2 * corners)
      this.#texCoords = texCoordsOf(look.texCoords, look.texCoordKey, corners);
    this.#shape = make('Shape') as ShapeNode;
    const geometry = make(KINDS[this.#form.primitive]);
    geometry._vf.solid = false;
    this.#mesh = geometry._mesh as CloudMesh;
    this.#mesh._numColComponents = 4;
    this.#looksOf = this.#appearance(make);
    this.#shape.addChild(this.#looksOf, 'appearance');
    // What fades shows what is behind it, if its author says nothing else.
    if (this.#colors?.fades && this.#looksOf._origSortType === 'auto')
      this.#shape._cf.appearance!.node = fading(this.#looksOf, make('DepthMode'));
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

  /** Takes another look; false: that needs another Shape. `look` may change later. */
  wears(look: Look): boolean {
    if (!sameShape(look, this.#look)) return false;
    if (sameForm(look, this.#look)) return true;
    this.#look = { ...look };
    this.#form = formOf(look);
    this.#form.turn?.(this.#view);
    this.#spreadNormals();
    this.#stale = true;
    return true;
  }

  /** Shows particles as they were `since` seconds before the end of the last step, when x3dom draws next. */
  show(shown: Shown, since: number): void {
    const seen = this.#seen;
    seen.take(shown, since, this.#look.length);
    // Not while x3dom asks the scene how large it is: that would begin anew in the middle.
    this.#bounds.hold(seen.low, seen.high, this.#form.reach);
    this.#stale = true;
    const { _scene: scene } = this.#look.doc;
    const any = seen.count > 0;
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
    const turned = this.#turnView();
    if (turned) this.#turnForm();
    if (this.#stale || (turned && (this.#form.turn || this.#sorted))) this.#write();
    this.#stale = false;
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

  #turnForm(): void {
    if (!this.#form.turn) return;
    this.#form.turn(this.#view);
    this.#spreadNormals();
  }

  #spreadNormals(): void {
    spread(this.#form.normals, this.#mesh._normals[0] as Float32Array);
    this.#shape._dirty.normals = true;
  }

  #write(): void {
    const { corners } = this.#form;
    const seen = this.#seen;
    const { count } = seen;
    if (count > this.#room) this.#grow(count);
    if (this.#room === 0) return;
    if (this.#sorted) farthestFirst(seen, this.#view);
    const positions = this.#mesh._positions[0] as Float32Array;
    this.#form.write(seen, positions);
    const most = Math.max(count, this.#drawn);
    positions.fill(NOWHERE, 3 * corners * count, 3 * corners * most);
    this.#drawn = count;
    this.#upload('POSITION', positions, 3 * corners * most);
    this.#ramp(this.#colors, 'COLOR', this.#mesh._colors[0], 4 * corners * count);
    this.#ramp(this.#texCoords, 'TEXCOORD', this.#mesh._texCoords[0], 2 * corners * count);
  }

  /** What goes by ages. */
  #ramp(
    ramp: Ramp | undefined,
    list: 'COLOR' | 'TEXCOORD',
    numbers: ArrayLike<number> | undefined,
    count: number,
  ): void {
    if (!ramp) return;
    ramp.write(this.#seen, this.#form.corners, numbers as Float32Array);
    this.#upload(list, numbers as Float32Array, count);
  }

  #upload(list: Parameters<typeof upload>[2], numbers: Float32Array, count: number): void {
    upload(this.#shape, this.#look.doc, list, numbers, count);
  }

  #grow(count: number): void {
    this.#room = Math.ceil(GROWTH * count);
    makeRoom(this.#mesh, this.#form, this.#room, this.#colors !== undefined);
    this.#drawn = 0;
    const { _dirty: dirty } = this.#shape;
    for (const part of Object.keys(dirty)) dirty[part] = true;
  }
}
