import { nodeTypes } from '../physics-core/inside.js';
import {
  attachListener,
  attributeNames,
  checkPlace,
  detachListener,
  camel,
  keepInternals,
  ownBinding,
  page,
  STRUCTURE,
  tagOf,
  type Binding,
  type Explanation,
  type NodeType,
} from './bridge/index.js';
import type { ElementProperties, PhysicsEventMap } from './properties.js';
import { setAgain } from './set-again.js';
import { shownInPage, type World } from './world.js';

// Servers that render pages may import this, too; they have neither.
const Base = globalThis.HTMLElement ?? (class {} as typeof HTMLElement);
const { prototype: native } = globalThis.Element ?? Base;

type Add = Parameters<EventTarget['addEventListener']>;

/**
 * The custom element around a physics node: its properties come from the node's table, see `forType`. An element
 * that stands for another one by `use` has that one's properties.
 */
export class X3DNodeElement extends Base {
  /** @internal */
  static readonly type: NodeType;

  constructor() {
    super();
    keepInternals(this);
  }

  /** @internal */
  protected get binding(): Binding {
    return page.bindingOf(this) ?? ownBinding(this)!;
  }

  /** The world it lives in; before the start, too. */
  get world(): World | undefined {
    return shownInPage(page.worldOf(this));
  }

  /** What the simulation has for it, as plain data. */
  explain(): Explanation {
    return page.explain(this);
  }

  connectedCallback(): void {
    page.met(this);
    takeEarlyProperties(this);
    queueMicrotask(() => checkPlace(this));
  }

  attributeChangedCallback(name: string, before: string | null, after: string | null): void {
    if (before === after) ownBinding(this)?.attributeRepeated(name);
    else ownBinding(this)?.attributeChanged(name);
  }
}

/**
 * x3dom replaces these on the elements it reads, unless they carry its `__` names already; its own answer defaults for
 * absent attributes and throw once the element has left the scene.
 */
const NATIVE = {
  __addEventListener: native.addEventListener,
  __removeEventListener: native.removeEventListener,
  __getAttribute: native.getAttribute,
  __setAttribute: native.setAttribute,
  __hasAttribute: native.hasAttribute,
};
for (const [name, value] of Object.entries(NATIVE))
  Object.defineProperty(X3DNodeElement.prototype, name, { value });

/** When x3dom lets go of an element it leaves null in place of these: the setter takes it and nothing happens. */
const LISTENING = { addEventListener: attachListener, removeEventListener: detachListener };
for (const [name, act] of Object.entries(LISTENING)) {
  const method = function (this: Element, ...args: Add): void {
    act(this, ...args);
  };
  Object.defineProperty(X3DNodeElement.prototype, name, { get: () => method, set: () => {} });
}

function takeEarlyProperties(element: X3DNodeElement): void {
  const { type } = element.constructor as typeof X3DNodeElement;
  const names = [...Object.keys(type.fields), ...additions(type).map(camel)];
  setAgain(element, new Set(names.flatMap((each) => [each, each.toLowerCase()])));
}

/** Attributes in HTML's lowercase, and as XML has them. */
function attributesOf(type: NodeType): string[] {
  const names = Object.entries(type.fields).flatMap(([name, field]) => attributeNames(name, field));
  return [...new Set(names.flatMap((name) => [name.toLowerCase(), name]))];
}

/** Additions of ours that are no fields. */
const additions = (type: NodeType): string[] => STRUCTURE[type.name] ?? [];

/** These properties are their attributes, as `id` is. */
function defineReflection(prototype: X3DNodeElement, name: string): void {
  Object.defineProperty(prototype, camel(name), {
    configurable: true,
    enumerable: true,
    get(this: Element) {
      const text = native.getAttribute.call(this, name);
      if (name === 'batch') return text !== 'false';
      return name === 'default' ? text !== null && text !== 'false' : (text ?? '');
    },
    set(this: Element, value: unknown) {
      const usual = name === 'batch';
      if (value === null || value === undefined || value === usual)
        native.removeAttribute.call(this, name);
      else native.setAttribute.call(this, name, value === true ? '' : String(value));
    },
  });
}

function defineProperties(prototype: X3DNodeElement, type: NodeType): void {
  for (const name in type.fields) {
    const property = {
      configurable: true,
      get(this: X3DNodeElement) {
        return this['binding'].get(name);
      },
      set(this: X3DNodeElement, value: unknown) {
        this['binding'].set(name, value);
      },
    };
    // Some frameworks know attributes only, and set the property of that name: `anchorpoint`.
    Object.defineProperty(prototype, name.toLowerCase(), property);
    Object.defineProperty(prototype, name, { ...property, enumerable: true });
  }
}

/** What the class of one node's element has beside its base. */
export interface NodeElementStatics {
  /** @internal */
  readonly type: NodeType;
  readonly tag: string;
  readonly observedAttributes: string[];
}

export type X3DNodeElementClass = NodeElementStatics & (new () => X3DNodeElement);

/** The base class of one node's element, made from its table. */
export function forType<
  Name extends keyof ElementProperties,
  Base extends typeof X3DNodeElement = typeof X3DNodeElement,
>(
  name: Name,
  base?: Base,
  type = nodeTypes[name] as NodeType,
): NodeElementStatics & (new () => InstanceType<Base> & ElementProperties[Name]) {
  class TypedElement extends (base ?? X3DNodeElement) {
    static override readonly type = type;
    static readonly tag = tagOf(type);
    static readonly observedAttributes = attributesOf(type);
  }
  defineProperties(TypedElement.prototype, type);
  for (const name of additions(type)) defineReflection(TypedElement.prototype, name);
  return TypedElement as never;
}

declare global {
  // Those of plain tags, of all that stands above them, of the document and the window. Only by an interface that says
  // nothing of its own can one of the platform's be extended.
  /* eslint-disable @typescript-eslint/no-empty-object-type */
  interface ElementEventMap extends PhysicsEventMap {}
  interface GlobalEventHandlersEventMap extends PhysicsEventMap {}
  /* eslint-enable @typescript-eslint/no-empty-object-type */
}
