import type { ProblemReport } from '../../../physics-core/inside.js';
import type { Readers } from '../scopes/readers.js';
import type { Scope } from '../scopes/scope.js';
import { loadFailed } from '../words/load-failed.js';
import { setUpDropped } from '../x3dom/late.js';
import { lacks, learnShapes } from '../x3dom/shapes/shapes.js';
import { lateCode } from './late-tags.js';

interface Scene {
  readonly x3d: Element;
  readonly readers: Readers;
  readonly scopes: { around(element: Element): Scope | undefined };
  readonly tree: { connect(root: Element, scope: Scope): void };
  noteFault(element: Element, say: () => ProblemReport): void;
}

/** Tags whose code comes in a chunk: what they are is known once it is there, to us and to x3dom. */
export class Unread {
  readonly #scene: Scene;
  #met = new Set<Element>();
  /** The code is on its way. */
  pending = false;

  constructor(scene: Scene) {
    this.#scene = scene;
  }

  add(element: Element): void {
    if (!lacks(element) && !lateCode(element)) return;
    this.#met.add(element);
    if (!this.pending) void this.#learn();
  }

  async #learn(): Promise<void> {
    this.pending = true;
    // What comes in the same task goes the same way.
    await undefined;
    const met = this.#met;
    this.#met = new Set();
    // One of them says it for all.
    const late = new Map([...met].map((element) => [lateCode(element), element]));
    if ([...met].some(lacks)) await learnShapes();
    for (const [code, element] of late)
      await code?.load().catch((error: unknown) => {
        const report = loadFailed(code.name, `what reads ${code.name}`, error);
        this.#scene.noteFault(element, () => report);
      });
    this.pending = false;
    setUpDropped(this.#scene.x3d, met);
    for (const element of met) this.#connect(element);
    if (this.#met.size > 0) void this.#learn();
  }

  /** It is a node now, or a stranger for good. */
  #connect(element: Element): void {
    const { readers, scopes, tree } = this.#scene;
    const scope = scopes.around(element);
    if (scope && !lacks(element) && !lateCode(element)) tree.connect(element, scope);
    for (const reader of readers.of(element)) reader.dirty();
  }
}
