import type { Units } from '../../../physics-core/inside.js';
import type { Binding } from '../nodes/binding.js';
import { attribute, isCustom, isInline, lowerName } from './dom.js';
import { Names } from './names.js';
import type { Scene } from '../scene.js';
import { unitsOf } from './units.js';

/**
 * One name scope with its units: the page tree of an `<x3d>`, the document of an Inline, or the body of a
 * prototype's instance.
 */
export class Scope {
  readonly scene: Scene;
  /** The element whose subtree it is. */
  readonly root: Element;
  /** What stands for it in the scope outside: the Inline, or the prototype's instance. */
  readonly host: Element | null;
  readonly parent: Scope | null;
  readonly units: Units;
  /** X3D version of its file. */
  readonly version: number;
  readonly names = new Names();
  readonly #statements = new Set<Element>();
  #foreign: Binding | undefined;
  observer: MutationObserver | undefined;

  constructor(scene: Scene, root: Element, host: Element | null, parent: Scope | null) {
    this.scene = scene;
    this.root = root;
    this.host = host;
    this.parent = parent;
    // A prototype's body has no head; it is written in the units of the file around it.
    this.units = !parent
      ? unitsOf(scene.x3d)
      : isInlineRoot(root)
        ? unitsOf(root.ownerDocument)
        : parent.units;
    this.version = !parent
      ? versionOf(scene.x3d)
      : isInlineRoot(root)
        ? versionOf(root.ownerDocument.documentElement)
        : parent.version;
  }

  /** Whether a node is the one that is to say that hyphenated tags here are no custom elements: once per scope. */
  firstForeign(binding: Binding): boolean {
    const { element } = binding;
    if (!element.localName.startsWith('x3d-') || isCustom(element)) return false;
    if (this.#foreign?.scope !== this) this.#foreign = binding;
    return this.#foreign === binding;
  }

  /** Where events of its nodes fire: the outermost host stands in the page. */
  get pageHost(): Element | null {
    return this.parent?.pageHost ?? this.host;
  }

  /** The body of a prototype's instance. */
  get isPrototype(): boolean {
    return this.host !== null && !isInline(this.host);
  }

  noteStatement(element: Element, present: boolean): void {
    const name = lowerName(element);
    if (name !== 'import' && name !== 'export' && name !== 'route') return;
    if (present) this.#statements.add(element);
    else this.#statements.delete(element);
    const local = attribute(element, 'AS') ?? attribute(element, 'importedDEF');
    if (name === 'import' && local) this.names.touch(local);
  }

  /** The element of a name, IMPORTed names included; `user` hears when that changes. */
  find(name: string, user?: Binding): Element | undefined {
    if (user) this.names.watch(name, user);
    return this.names.find(name) ?? this.#imported(name, user);
  }

  #imported(name: string, user: Binding | undefined): Element | undefined {
    for (const statement of this.#named('import')) {
      const inner = attribute(statement, 'importedDEF') ?? '';
      if ((attribute(statement, 'AS') ?? inner) !== name) continue;
      const inline = this.names.find(attribute(statement, 'inlineDEF') ?? '');
      const scope = inline && this.scene.scopeIn(inline);
      return scope?.exported(inner, user);
    }
    return undefined;
  }

  exported(name: string, user?: Binding): Element | undefined {
    for (const statement of this.#named('export')) {
      const local = attribute(statement, 'localDEF') ?? '';
      if ((attribute(statement, 'AS') ?? local) === name) return this.find(local, user);
    }
    // X3DOM's users often leave the EXPORT out.
    return this.find(name, user);
  }

  /** The ROUTEs from a node of this name. */
  routesFrom(name: string): Element[] {
    return this.#named('route').filter((route) => attribute(route, 'fromNode') === name);
  }

  /** The names that the scope outside imports from this one. */
  touchImports(): void {
    const { parent } = this;
    for (const statement of parent ? parent.#named('import') : []) {
      const local = attribute(statement, 'AS') ?? attribute(statement, 'importedDEF');
      if (local) parent!.names.touch(local);
    }
  }

  #named(name: string): Element[] {
    return [...this.#statements].filter((statement) => lowerName(statement) === name);
  }

  /** `shared-world` on an Inline holds for every collection inside it, further Inlines included. */
  get sharedWorld(): string | null {
    const own = this.host && isInline(this.host) ? attribute(this.host, 'shared-world') : null;
    return own ?? this.parent?.sharedWorld ?? null;
  }
}

/** HTML has no version of X3D, and then the newest holds. */
const versionOf = (x3d: Element): number => parseFloat(attribute(x3d, 'version') ?? '') || 4;

const isInlineRoot = (root: Element): boolean =>
  root.ownerDocument !== document && root.isConnected;
