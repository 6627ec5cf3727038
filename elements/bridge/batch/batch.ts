import { copyInto, identity, type Affine } from '../geometry/matrix.js';
import { fromX3D } from '../x3dom/matrices.js';
import { x3dom, type NodeContext } from '../x3dom/x3dom.js';
import type { X3DShape, X3DVolume, Way } from '../x3dom/renderer.js';
import { drawnFor, halfSizeOf } from './boxes.js';
import type { Group } from './group.js';
import { Instances } from './instances.js';
import { appearanceOf, colorOf, geometryOf } from './look.js';
import type { ManyRenderer } from './many.js';
import type { Member } from './member.js';
import type { Resting } from './ticks.js';
import { freeBuffers } from './meshes.js';

// Scratch: nothing is allocated in a frame.
const stands: Affine = identity();

/**
 * Bodies that look alike and stand in the same group, drawn by one Shape that stands there beside them: what is above
 * them, a Switch, a moving Transform, an Inline, has the effect on it that it has on them. It has no element, so that no
 * script, ROUTE or observer meets it.
 */
export class Batch {
  readonly members: Member[] = [];
  readonly instances = new Instances();
  readonly shape: X3DShape;
  readonly #renderer: ManyRenderer;
  readonly #group: Group;
  readonly #resting: Resting;
  readonly #volume: X3DVolume;
  /** Whose geometry and Appearance it draws. */
  #model!: Member;
  /** Where the group is in the world. */
  readonly #above: Affine = identity();
  /** What x3dom collected last to draw it. */
  #collection: unknown;

  constructor(renderer: ManyRenderer, group: Group, resting: Resting) {
    this.#resting = resting;
    this.#renderer = renderer;
    this.#group = group;
    const x = x3dom()!;
    this.#volume = new x.fields.BoxVolume() as X3DVolume;
    const nameSpace = group.node._nameSpace!;
    const { doc } = nameSpace;
    const context: NodeContext = { doc, runtime: undefined, xmlNode: null, nameSpace };
    this.shape = new x.nodeTypes.Shape(context) as X3DShape;
    this.shape._nameSpace = nameSpace;
    this.#behave(this.shape);
  }

  #behave(shape: X3DShape): void {
    const { collectDrawableObjects } = shape;
    shape.collectDrawableObjects = (...way) => {
      if (this.#isAgain(way) || !this.#renderer.ready(shape, way)) {
        for (const member of this.members) member.drawPlainly(...way);
        return undefined;
      }
      this.#stand(way);
      return collectDrawableObjects.apply(shape, way);
    };
    shape.getVolume = () => {
      this.instances.bounds(this.#volume);
      this.#volume.valid = this.#volume.min.x <= this.#volume.max.x;
      return this.#volume;
    };
    shape._graph.needCulling = false;
    // By its own frame it is nowhere.
    shape.doIntersect = () => false;
    // x3dom asks for an id before it draws something to be picked; each instance has its own.
    shape._objectID = 1;
  }

  /** The group is drawn in a second place. */
  #isAgain([, collection]: Way): boolean {
    const isAgain = this.#collection === collection;
    this.#collection = collection;
    return isAgain;
  }

  /** What is above may have moved. */
  #stand([matrix]: Way): void {
    const above = fromX3D(matrix, stands);
    if (above.every((value, i) => value === this.#above[i])) return;
    copyInto(above, this.#above);
    for (const member of this.members)
      member.place(member.readMatrix(), this.#above, this.instances);
  }

  // ---- members ----------------------------------------------------------------------------------------------------

  add(member: Member): void {
    member.at = this.instances.add();
    this.members.push(member);
    if (member.at === 0) {
      this.#copy(member);
      this.#renderer.add(this.shape, this.instances);
      this.#group.node.addChild(this.shape);
    }
    this.#group.add(member.top);
    freeBuffers(member.shape!, this.#renderer.gl);
    member.take((local) => this.#place(member, local));
    this.#resting.add(member.transform);
    this.reread(member);
  }

  remove(member: Member): void {
    const { at } = member;
    const last = this.members.pop()!;
    this.instances.remove(at);
    if (last !== member) {
      this.members[at] = last;
      last.at = at;
    }
    this.#group.delete(member.top);
    member.giveBack();
    this.#resting.delete(member.transform);
    if (this.members.length === 0) this.#end();
    else if (member === this.#model) this.#copy(this.members[0]);
  }

  #end(): void {
    this.#renderer.delete(this.shape);
    freeBuffers(this.shape, this.#renderer.gl);
    this.#group.node.removeChild(this.shape);
    this.instances.free(this.#renderer.gl);
  }

  /** Something of a member changed, though not so that it no longer belongs here. */
  reread(member: Member): void {
    if (member === this.#model) this.#copy(member);
    const { shape } = member;
    const size = halfSizeOf(geometryOf(shape!)!);
    this.instances.look(member.at, size, shape!._objectID, colorOf(shape!));
    this.#place(member, member.readMatrix());
    member.attach();
  }

  /** x3dom reads the geometry and the Appearance anew. */
  #copy(member: Member): void {
    const { shape } = this;
    this.#model = member;
    freeBuffers(shape, this.#renderer.gl);
    shape._shaderProperties = null;
    shape._cf.geometry.node = drawnFor(geometryOf(member.shape!)!);
    shape._cf.appearance.node = appearanceOf(member.shape!);
    shape._vf.isPickable = member.shape!._vf.isPickable;
  }

  #place(member: Member, local: Affine): void {
    const { node } = this.#group;
    member.place(local, this.#above, this.instances);
    // Where its own bounds are unknown, so are those of all above it.
    if (node.volumeValid()) node.invalidateVolume();
  }
}
