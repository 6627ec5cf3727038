import type { X3DNode } from '../x3dom/x3dom.js';
import type {
  X3DDrawnDocument,
  X3DProgram,
  X3DRenderer,
  X3DShape,
  Way,
} from '../x3dom/renderer.js';
import type { Instances } from './instances.js';
import { Passes, type Pass } from './passes.js';
import { instanced } from './shaders.js';

/** Has x3dom's renderer draw some Shapes many times, by the methods of its own that are put in the place of these. */
export class ManyRenderer {
  readonly gl: WebGL2RenderingContext;
  readonly #document: X3DDrawnDocument;
  readonly #renderer: X3DRenderer;
  readonly #passes: Passes;
  readonly #instances = new Map<X3DNode, Instances>();
  readonly #programs = new WeakMap<X3DProgram, X3DProgram>();
  /** What the next call draws many of. */
  #next: Instances | undefined;
  /** Why it can't. */
  failure: string | undefined;

  constructor(document: X3DDrawnDocument, beforeFrame: () => void) {
    this.#document = document;
    this.#renderer = document.ctx;
    this.gl = this.#renderer.ctx3d;
    if (!('drawElementsInstanced' in this.gl)) this.failure = 'there is no WebGL 2';
    this.#passes = new Passes(this.#renderer, beforeFrame);
    this.#hookShaders();
    this.#hookDraws();
  }

  add(shape: X3DNode, instances: Instances): void {
    this.#instances.set(shape, instances);
  }

  delete(shape: X3DNode): void {
    this.#instances.delete(shape);
  }

  /** Whether a Shape may be drawn many times in this frame. */
  ready(shape: X3DShape, [, collection, , , , clipPlanes]: Way): boolean {
    if (this.failure !== undefined || this.#isUnusual || collection.smallFeatureThreshold > 0)
      return false;
    if ((clipPlanes as unknown[]).length > 0) return false;
    const properties = shape.getShaderProperties(collection.viewarea) as { SHADOW: number };
    const { cache } = this.#renderer;
    const has = (shadows: true | null): boolean =>
      cache.getShaderByProperties(this.gl, shape, properties, null, shadows) !== undefined;
    return has(null) && (!properties.SHADOW || has(true));
  }

  /** Two pictures for glasses, or others than that of the page. */
  get #isUnusual(): boolean {
    return this.#renderer.VRMode !== 1 || this.#document._nodeBag.renderTextures.length > 0;
  }

  /** Another x3dom than we know shows in what is thrown: all is drawn plainly from then on. */
  attempt<T>(work: () => T): T | undefined {
    try {
      return work();
    } catch (error) {
      this.failure ??= error instanceof Error ? error.message : String(error);
      return undefined;
    }
  }

  // ---- x3dom's methods --------------------------------------------------------------------------------------------

  #hookShaders(): void {
    const { cache } = this.#renderer;
    const { getShaderByProperties } = cache;
    cache.getShaderByProperties = (gl, shape, properties, pick, shadows) => {
      const plain = getShaderByProperties.call(cache, gl, shape, properties, pick, shadows);
      if (!plain || !this.#instances.has(shape)) return plain;
      const pass = pick != null ? 'pick' : shadows != null ? 'shadow' : 'picture';
      return this.attempt(() => this.#program(plain, pass));
    };
  }

  /** x3dom lets go of all programs that are in its list. */
  #program(plain: X3DProgram, pass: Pass): X3DProgram {
    const known = this.#programs.get(plain);
    if (known) return known;
    const program = instanced(this.gl, plain, pass);
    this.#programs.set(plain, program);
    this.#renderer.cache.shaders[program.shaderID] = program;
    return program;
  }

  /** It says what it draws with the positions, and right after that has it drawn. */
  #hookDraws(): void {
    const renderer = this.#renderer;
    const { drawElements, drawArrays, setVertexAttribPointerPosition } = renderer;
    renderer.setVertexAttribPointerPosition = (gl, shape, ...rest) => {
      setVertexAttribPointerPosition.call(renderer, gl, shape, ...rest);
      this.#next = this.#instances.get(shape);
      this.#next?.bind(gl, this.#passes);
    };
    renderer.drawElements = (gl, mode, count, type, offset, times) => {
      drawElements.call(renderer, gl, mode, count, type, offset, this.#next?.count ?? times);
      this.#drawn(gl);
    };
    renderer.drawArrays = (gl, mode, first, count, times) => {
      drawArrays.call(renderer, gl, mode, first, count, this.#next?.count ?? times);
      this.#drawn(gl);
    };
  }

  #drawn(gl: WebGL2RenderingContext): void {
    this.#next?.unbind(gl);
    this.#next = undefined;
  }

  /** x3dom's own methods again. */
  unhook(): void {
    const { cache } = this.#renderer;
    Reflect.deleteProperty(cache, 'getShaderByProperties');
    this.#passes.unhook();
    const names = ['setVertexAttribPointerPosition', 'drawElements', 'drawArrays'];
    for (const name of names) Reflect.deleteProperty(this.#renderer, name);
  }
}
