import { x3dom, type X3DDocument, type X3DNode } from '../x3dom/x3dom.js';
import type {
  X3DBounded,
  X3DDrawnDocument,
  X3DProgram,
  X3DRenderer,
  X3DShape,
  X3DTransform,
  Way,
} from '../x3dom/renderer.js';
import { Batch, type BatchHost } from './batch.js';
import { Group } from './group.js';
import { appearanceOf, geometryOf, Looks } from './look.js';
import { Member } from './member.js';
import { instanced, type Pass } from './shaders.js';
import { hastenTicks } from './ticks.js';
import { watch, watchFlags, type Method } from './watch.js';

/** As many as are alike are worth a batch. */
export const LEAST = 8;

/** Members that look alike and stand in one group. */
interface Kind {
  readonly members: Set<Member>;
  batch?: Batch | undefined;
  /** The last one has left. */
  readonly end: () => void;
}

/** All bodies of one document, and which of them are drawn in one call. */
export class Batches implements BatchHost {
  readonly document: X3DDocument;
  readonly gl: WebGL2RenderingContext;
  readonly #renderer: X3DRenderer;
  readonly #members = new Map<X3DNode, Member>();
  /** Those that may be drawn otherwise by now. */
  readonly #changed = new Set<Member>();
  readonly #watched = new WeakSet<X3DNode>();
  readonly #groups = new WeakMap<X3DNode, Group>();
  readonly #kinds = new WeakMap<X3DNode, Map<string, Kind>>();
  readonly #kindOf = new Map<Member, Kind>();
  readonly #batches = new Map<X3DNode, Batch>();
  readonly #looks = new Looks();
  readonly #programs = new WeakMap<X3DProgram, X3DProgram>();
  /** What the next draw call draws many of. */
  #next: Batch | undefined;
  /** Why all is drawn plainly. */
  #failure: string | undefined;
  readonly #onfail: (why: string) => void;

  constructor(document: X3DDocument, onfail: (why: string) => void) {
    this.document = document;
    this.#onfail = onfail;
    this.#renderer = (document as X3DDrawnDocument).ctx;
    this.gl = this.#renderer.ctx3d;
    hastenTicks();
    this.#hook();
  }

  // ---- what changed -----------------------------------------------------------------------------------------------

  /** A Transform that a body moves came, or is to be looked at anew. */
  note(transform: X3DNode, allowed: boolean): void {
    let member = this.#members.get(transform);
    if (!member) this.#members.set(transform, (member = new Member(transform as X3DTransform)));
    member.allowed = allowed;
    this.#changed.add(member);
  }

  /** Hears of all that decides how a member is drawn; what several share is heard once. */
  #watch({ transform, shape, parent }: Member): void {
    this.#hear(transform, ['fieldChanged', 'nodeChanged', 'parentAdded', 'parentRemoved']);
    if (parent && !this.#watched.has(parent)) {
      this.#watched.add(parent);
      watch(parent, () => this.#groups.get(parent)?.changed(), 'nodeChanged');
    }
    if (!shape) return;
    if (this.#hear(shape, ['fieldChanged', 'nodeChanged']))
      watchFlags(shape, () => this.#touch(shape));
    const appearance = appearanceOf(shape);
    for (const node of [geometryOf(shape), appearance]) if (node) this.#hear(node, ['fieldChanged']);
    const material = appearance?._cf.material.node;
    if (material) this.#hear(material, ['highlight']);
  }

  #hear(node: X3DNode, methods: Method[]): boolean {
    if (this.#watched.has(node)) return false;
    this.#watched.add(node);
    watch(node, () => this.#touch(node), ...methods);
    return true;
  }

  /** The members that a node belongs to. */
  #touch(node: X3DNode): void {
    const member = this.#members.get(node);
    if (member) this.#changed.add(member);
    else for (const parent of node._parentNodes) this.#touch(parent);
  }

  // ---- who is drawn with whom -------------------------------------------------------------------------------------

  /** Before each frame: nothing of it may be otherwise when x3dom draws. */
  #update(): void {
    if (this.#changed.size === 0) return;
    const changed = [...this.#changed];
    for (const member of changed) {
      if (member.gone) this.#forget(member);
      else this.#sort(member);
    }
    this.#looks.forget();
    // What was found out just now is no change.
    this.#changed.clear();
  }

  #sort(member: Member): void {
    const { shape } = member;
    const before = this.#kindOf.get(member);
    member.read();
    this.#watch(member);
    const kind = member.why === undefined ? this.#kind(member) : undefined;
    if (kind === before && member.shape === shape) return before?.batch?.reread(member);
    this.#leave(member);
    if (kind) this.#join(member, kind);
  }

  #kind({ parent, shape }: Member): Kind {
    const kinds = this.#kinds.get(parent!) ?? new Map<string, Kind>();
    this.#kinds.set(parent!, kinds);
    const look = this.#looks.of(shape!);
    const end = (): void => void kinds.delete(look);
    const kind = kinds.get(look) ?? { members: new Set(), end };
    kinds.set(look, kind);
    return kind;
  }

  #join(member: Member, kind: Kind): void {
    this.#kindOf.set(member, kind);
    kind.members.add(member);
    if (kind.batch) kind.batch.add(member);
    else if (kind.members.size >= LEAST) this.#form(kind, member.parent!);
  }

  #form(kind: Kind, parent: X3DBounded): void {
    const group = this.#groups.get(parent) ?? new Group(parent);
    this.#groups.set(parent, group);
    const batch = (kind.batch = new Batch(this, group));
    this.#batches.set(batch.shape, batch);
    for (const member of kind.members) batch.add(member);
  }

  #leave(member: Member): void {
    const kind = this.#kindOf.get(member);
    if (!kind) return;
    this.#kindOf.delete(member);
    kind.members.delete(member);
    kind.batch?.remove(member);
    // Not at once where one is missing: it may be back in the next frame.
    if (kind.members.size < LEAST / 2) this.#dissolve(kind);
    if (kind.members.size === 0) kind.end();
  }

  #dissolve(kind: Kind): void {
    const { batch } = kind;
    if (!batch) return;
    kind.batch = undefined;
    this.#batches.delete(batch.shape);
    for (const member of [...batch.members]) batch.remove(member);
  }

  #forget(member: Member): void {
    this.#members.delete(member.transform);
    this.#leave(member);
  }

  // ---- x3dom's renderer -------------------------------------------------------------------------------------------

  #hook(): void {
    const renderer = this.#renderer;
    const { cache } = renderer;
    const { renderScene, drawElements, drawArrays, setVertexAttribPointerPosition } = renderer;
    const { getShaderByProperties } = cache;
    renderer.renderScene = (...args) => {
      this.#beforeFrame();
      renderScene.apply(renderer, args);
    };
    cache.getShaderByProperties = (gl, shape, properties, pick, shadow) => {
      const plain = getShaderByProperties.call(cache, gl, shape, properties, pick, shadow);
      if (!plain || !this.#batches.has(shape)) return plain;
      return this.#tried(() => this.#program(plain, passOf(pick, shadow)));
    };
    renderer.setVertexAttribPointerPosition = (gl, shape, ...rest) => {
      setVertexAttribPointerPosition.call(renderer, gl, shape, ...rest);
      this.#next = this.#batches.get(shape);
      this.#next?.instances.bind(gl);
    };
    renderer.drawElements = (gl, mode, count, type, offset, instances) => {
      const many = this.#next?.instances;
      drawElements.call(renderer, gl, mode, count, type, offset, many ? many.count : instances);
      if (many) this.#drawn(gl);
    };
    renderer.drawArrays = (gl, mode, first, count, instances) => {
      const many = this.#next?.instances;
      drawArrays.call(renderer, gl, mode, first, count, many ? many.count : instances);
      if (many) this.#drawn(gl);
    };
  }

  #drawn(gl: WebGL2RenderingContext): void {
    this.#next!.instances.unbind(gl);
    this.#next = undefined;
  }

  #unhook(): void {
    const renderer = this.#renderer;
    for (const name of ['renderScene', 'drawElements', 'drawArrays', 'setVertexAttribPointerPosition'])
      Reflect.deleteProperty(renderer, name);
    Reflect.deleteProperty(renderer.cache, 'getShaderByProperties');
  }

  #beforeFrame(): void {
    if (this.#failure === undefined) this.#tried(() => this.#update());
    else this.#undo();
  }

  /** x3dom's program with the changes for many; it lets go of all that are in its list. */
  #program(plain: X3DProgram, pass: Pass): X3DProgram {
    const known = this.#programs.get(plain);
    if (known) return known;
    const program = instanced(this.gl, plain, pass);
    this.#programs.set(plain, program);
    this.#renderer.cache.shaders[program.shaderID] = program;
    return program;
  }

  ready(shape: X3DShape, [, collection, , , , clipPlanes]: Way): boolean {
    const { VRMode, cache } = this.#renderer;
    if (this.#failure !== undefined || VRMode !== 1 || collection.smallFeatureThreshold > 0) return false;
    if ((clipPlanes as unknown[]).length > 0) return false;
    if ((this.document as X3DDrawnDocument)._nodeBag.renderTextures.length > 0) return false;
    const properties = shape.getShaderProperties(collection.viewarea) as { SHADOW: number };
    return (
      cache.getShaderByProperties(this.gl, shape, properties) !== undefined &&
      (!properties.SHADOW ||
        cache.getShaderByProperties(this.gl, shape, properties, null, true) !== undefined)
    );
  }

  // ---- where it can't be ------------------------------------------------------------------------------------------

  /** Another x3dom than we know: all is drawn plainly from now on. */
  #tried<T>(work: () => T): T | undefined {
    try {
      return work();
    } catch (error) {
      this.#failure ??= error instanceof Error ? error.message : String(error);
      return undefined;
    }
  }

  #undo(): void {
    for (const kind of new Set(this.#kindOf.values())) this.#dissolve(kind);
    this.#members.clear();
    this.#kindOf.clear();
    this.#unhook();
    this.#onfail(this.#failure!);
  }
}

const passOf = (pick: unknown, shadow: unknown): Pass =>
  pick != null ? 'pick' : shadow != null ? 'shadow' : 'picture';
