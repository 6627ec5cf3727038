import type { Units } from '../../../physics-core/inside.js';
import { attribute, fileOf, isInline, lowerName } from '../words/dom.js';
import { Names, type Watcher } from './names.js';
import type { Scopes } from './scopes.js';
import { unitsOf } from '../words/units.js';

/**
 * One name scope with its units: the page tree of an `<x3d>`, the document of an Inline, or the body of a
 * prototype's instance.
 */
export class Scope {
  /** All of the same `<x3d>`. */
  readonly all: Scopes;
  /** The element whose subtree it is. */
  readonly root: Element;
  /** What stands for it in the scope outside: the Inline, or the prototype's instance. */
  readonly host: Element | null;
  readonly parent: Scope | null;
  readonly units: Units;
  /** X3D version of its file. */
  readonly version: number;
  readonly names = new Names();
  readonly #statements = {
    import: new Set<Element>(),
    export: new Set<Element>(),
    route: new Set<Element>(),
  };

  constructor(all: Scopes, root: Element, host: Element | null, parent: Scope | null) {
    this.all = all;
    this.root = root;
    this.host = host;
    this.parent = parent;
    // A prototype's body has no head; it is written in the units of the file around it.
    const file = !parent ? all.x3d : host && isInline(host) ? fileOf(root) : undefined;
    this.units = file ? unitsOf(file) : parent!.units;
    this.version = file ? versionOf(file) : parent!.version;
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
    if (present) this.#statements[name].add(element);
    else this.#statements[name].delete(element);
    const local = localName(element);
    if (name === 'import' && local) this.names.touch(local);
  }

  /** The element of a name, IMPORTed names included; `user` hears when that changes. */
  find(name: string, user?: Watcher): Element | undefined {
    if (user) this.names.watch(name, user);
    return this.names.find(name) ?? this.#imported(name, user);
  }

  #imported(name: string, user: Watcher | undefined): Element | undefined {
    for (const statement of this.#named('import')) {
      const inner = attribute(statement, 'importedDEF') ?? '';
      if ((attribute(statement, 'AS') ?? inner) !== name) continue;
      const inline = this.names.find(attribute(statement, 'inlineDEF') ?? '');
      const scope = inline && this.all.in(inline);
      return scope?.exported(inner, user);
    }
    return undefined;
  }

  exported(name: string, user?: Watcher): Element | undefined {
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
      const local = localName(statement);
      if (local) parent!.names.touch(local);
    }
  }

  #named(name: 'import' | 'export' | 'route'): Element[] {
    return [...this.#statements[name]];
  }

  /** The elements that stand for `element` by USE: here, and where it is IMPORTed in the scopes outside. */
  usesOf(element: Element): Element[] {
    const own = this.names.usesOf(element);
    return this.parent ? [...own, ...this.parent.#usesOfImported(element)] : own;
  }

  #usesOfImported(element: Element): Element[] {
    const names = new Set(this.#named('import').map(localName));
    if (names.size === 0) return [];
    const uses = [...names]
      .filter((name) => name && this.find(name) === element)
      .flatMap((name) => this.names.usesNamed(name!));
    return this.parent ? [...uses, ...this.parent.#usesOfImported(element)] : uses;
  }

  /** `shared-world` on an Inline holds for every collection inside it, further Inlines included. */
  get sharedWorld(): string | null {
    const own = this.host && isInline(this.host) ? attribute(this.host, 'shared-world') : null;
    return own ?? this.parent?.sharedWorld ?? null;
  }
}

/** The name that an IMPORT gives. */
const localName = (statement: Element): string | null =>
  attribute(statement, 'AS') ?? attribute(statement, 'importedDEF');

/** HTML has no version of X3D, and then the newest holds. */
function versionOf(file: Document | Element): number {
  const x3d = file instanceof Document ? file.documentElement : file;
  return parseFloat(attribute(x3d, 'version') ?? '') || 4;
}
