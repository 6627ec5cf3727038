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
import { Looks } from './look.js';
import { Member } from './member.js';
import { instanced, type Pass } from './shaders.js';
import { hastenTicks } from './ticks.js';

/** As many as are alike are worth a batch. */
export const LEAST = 8;

/** Members that look alike and stand in one group. */
interface Kind {
  members: Set<Member>;
  batch?: Batch | undefined;
}

/** All bodies of one document, and which of them are drawn in one call. */
export class Batches implements BatchHost {
  readonly document: X3DDocument;
  readonly gl: WebGL2RenderingContext;
  readonly #renderer: X3DRenderer;
  readonly #members = new Map<X3DNode, Member>();
  readonly #kinds = new Map<X3DBounded, Map<string, Kind>>();
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

  // ---- who is drawn with whom -------------------------------------------------------------------------------------

  /** A Transform that a body moves came, or is to be looked at anew. */
  note(transform: X3DNode, allowed: boolean): void {
    let member = this.#members.get(transform);
    if (!member) this.#members.set(transform, (member = new Member(transform as X3DTransform)));
    member.allowed = allowed;
    member.stale = true;
  }

  /** Before each frame: nothing of it may be otherwise when x3dom draws. */
  #update(): void {
    const changed: Member[] = [];
    for (const member of this.#members.values()) {
      if (member.gone) this.#forget(member);
      else if (member.changed) changed.push(member);
    }
    for (const member of changed) this.#place(member);
    for (const { shape } of changed) if (shape) settle(shape);
    this.#looks.forget();
    for (const batch of this.#batches.values()) batch.update();
  }

  #place(member: Member): void {
    const { shape } = member;
    const before = this.#kindOf.get(member);
    member.read();
    const kind = member.why === undefined ? this.#kind(member) : undefined;
    if (kind === before && member.shape === shape) return before?.batch?.reread(member);
    this.#leave(member);
    if (kind) this.#join(member, kind);
  }

  #kind({ parent, shape }: Member): Kind {
    const kinds = this.#kinds.get(parent!) ?? new Map<string, Kind>();
    this.#kinds.set(parent!, kinds);
    const look = this.#looks.of(shape!);
    const kind = kinds.get(look) ?? { members: new Set() };
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
    const batch = (kind.batch = new Batch(this, parent));
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

/** What has changed of it is known now. Where it is drawn by itself, x3dom has yet to see it. */
function settle(shape: X3DShape): void {
  if (shape._webgl) return;
  shape.unsetDirty();
  shape._shaderProperties = null;
}
