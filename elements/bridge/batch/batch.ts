import { x3dom, type NodeContext, type X3DDocument } from '../x3dom/x3dom.js';
import type { X3DBounded, X3DShape, X3DVolume, Way } from '../x3dom/renderer.js';
import { Instances } from './instances.js';
import { appearanceOf, colorOf, geometryOf } from './look.js';
import type { Member } from './member.js';

/** Whom a batch asks. */
export interface BatchHost {
  readonly document: X3DDocument;
  readonly gl: WebGL2RenderingContext;
  /** Whether batches may be drawn in this frame. */
  ready(batch: X3DShape, way: Way): boolean;
}

/**
 * Bodies that look alike and stand in the same group, drawn by one Shape that stands there beside them: what is above
 * them, a Switch, a moving Transform, an Inline, has the effect on it that it has on them. It has no element, so that no
 * script, pick or observer meets it.
 */
export class Batch {
  readonly members: Member[] = [];
  readonly instances = new Instances();
  readonly shape: X3DShape;
  readonly #places = new Map<Member, number>();
  readonly #host: BatchHost;
  readonly #parent: X3DBounded;
  #model: Member | undefined;

  constructor(host: BatchHost, parent: X3DBounded) {
    this.#host = host;
    this.#parent = parent;
    const x = x3dom()!;
    const nameSpace = parent._nameSpace ?? host.document._scene!._nameSpace!;
    const context: NodeContext = { doc: host.document, runtime: undefined, xmlNode: null, nameSpace };
    const shape = (this.shape = new x.nodeTypes.Shape(context) as X3DShape);
    shape._nameSpace = nameSpace;
    // Its members have the bounds; what has none would be left out as out of sight.
    const nowhere = new x.fields.BoxVolume() as X3DVolume;
    shape.getVolume = () => nowhere;
    shape._graph.needCulling = false;
    shape.doIntersect = () => false;
    // x3dom asks for an id before it draws something to be picked; each instance has its own.
    shape._objectID = 1;
    const { collectDrawableObjects } = shape;
    shape.collectDrawableObjects = (...way) => {
      if (host.ready(shape, way)) return collectDrawableObjects.call(shape, ...way);
      for (const member of this.members) member.drawPlainly(...way);
      return undefined;
    };
  }

  add(member: Member): void {
    const at = this.instances.add();
    this.members.push(member);
    this.#places.set(member, at);
    this.instances.name(at, member.shape!._objectID);
    member.take();
    if (this.members.length > 1) return;
    this.model(member);
    this.#parent.addChild(this.shape);
  }

  remove(member: Member): void {
    const at = this.#places.get(member)!;
    const last = this.members.pop()!;
    this.instances.remove(at);
    this.#places.delete(member);
    if (last !== member) {
      this.members[at] = last;
      this.#places.set(last, at);
    }
    member.giveBack();
    if (this.members.length === 0) this.#end();
    else if (member === this.#model) this.model(this.members[0]);
  }

  #end(): void {
    this.shape._cleanupGLObjects?.(true);
    this.#parent.removeChild(this.shape);
    this.instances.free(this.#host.gl);
  }

  /** Whose geometry and Appearance the Shape draws: x3dom reads them anew. */
  model(member: Member): void {
    const { shape } = this;
    this.#model = member;
    shape._cleanupGLObjects?.(true);
    shape._shaderProperties = null;
    shape._cf.geometry.node = geometryOf(member.shape!);
    shape._cf.appearance.node = appearanceOf(member.shape!);
    shape._vf.isPickable = member.shape!._vf.isPickable;
  }

  /** The look of one of them was read anew, and is what it was. */
  reread(member: Member): void {
    if (member === this.#model) this.model(member);
  }

  /** Where they are, and which colours they have. */
  update(): void {
    const { members, instances } = this;
    for (let at = 0; at < members.length; at++) {
      const member = members[at];
      instances.paint(at, colorOf(member.shape!));
      const { seen } = member;
      if (!member.moved && seen === member.shown) continue;
      member.moved = false;
      member.shown = seen;
      if (seen) instances.place(at, member.transform._trafo);
      else instances.hide(at);
    }
  }
}
