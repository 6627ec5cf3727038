// Types of all tags for the templates of frameworks, from the field tables and from what the ui says of itself.
import { camel, tagOf } from '../../elements/bridge/words/dom.js';
import { eventsAt } from '../../elements/bridge/words/event-types.js';
import type { UIDescription } from '../../elements/ui/ui-element.js';
import type { NodeType } from '../../physics-core/inside.js';
import { additionsOf, attributesOf, describe, givenType } from './manifest-fields.js';
import { sceneTags } from './scene-tags.js';

const quote = (name: string): string => (/^\w+$/.test(name) ? name : `'${name}'`);

const entry = (doc: string, key: string, type: string): string =>
  `  /** ${doc} */\n  ${quote(key)}?: ${type};`;

/** By property name, since frameworks set properties where there are any; and by attribute. */
function properties(type: NodeType): string[] {
  const fields = attributesOf(type).flatMap(({ attribute, name, field }) =>
    [...new Set([name, attribute])].map((key) =>
      entry(describe(field), key, givenType(name, field)),
    ),
  );
  const additions = additionsOf(type).flatMap(({ attribute, type: text, doc }) =>
    [...new Set([attribute, camel(attribute)])].map((key) => entry(doc, key, text)),
  );
  return [...fields, ...additions];
}

const attributes = (type: NodeType): string =>
  `export interface ${type.name}Attributes extends NodeAttributes {\n${properties(type).join('\n')}\n}`;

/** An element of the ui: it has no node. */
export interface UIClass {
  readonly tag: string;
  readonly name: string;
  readonly description: UIDescription;
}

const uiName = ({ tag }: UIClass): string => {
  const name = camel(tag.replace('x3d-', ''));
  return `${name[0]!.toUpperCase()}${name.slice(1)}Attributes`;
};

function uiAttributes(element: UIClass): string {
  const lines = element.description.attributes.map(({ name, type, doc }) => entry(doc, name, type));
  return `export interface ${uiName(element)} {\n${lines.join('\n')}\n}`;
}

const union = (words: readonly string[]): string => words.map((word) => `'${word}'`).join(' | ');

const tag = (name: string, attributes: string, element: string, events: string): string =>
  `  '${name}': { attributes: ${attributes}; element: ${element}; events: ${events} };`;

const physicsTags = (types: NodeType[], ui: readonly UIClass[]): string => {
  const nodes = types.map((type) =>
    tag(
      tagOf(type),
      `${type.name}Attributes`,
      `X3D${type.name}Element`,
      union(eventsAt(type.name)),
    ),
  );
  const views = ui.map((each) => tag(each.tag, uiName(each), each.name, 'never'));
  return `/** What each tag takes, which element it is, and what that fires. */
export interface PhysicsTags {\n${[...nodes, ...views].join('\n')}\n}\n`;
};

const head = (elements: readonly string[]): string => `import type {
  PhysicsEventMap,
  ${elements.join(',\n  ')},
} from './index.js';

/** X3D's own, which any node may have. */
export interface NodeAttributes {
  DEF?: string;
  def?: string;
  USE?: string;
  use?: string;
  containerField?: string;
  containerfield?: string;
}
`;

const TAIL = `
/** Numbers as x3dom's attributes take them: as text, or one or several of them, which become text. */
export type NumberText = string | number | readonly number[];

export interface SceneAttributes extends NodeAttributes {
  nameSpaceName?: string;
  isPickable?: 'true' | 'false';
}

/** Tags of x3dom's own that scenes with physics are made of. */
${sceneTags()}
type Tag = keyof PhysicsTags;
type Listener<Event extends keyof PhysicsEventMap> = (event: PhysicsEventMap[Event]) => void;

/** What each tag takes and tells: \`oncollisionstart\`. */
export type PhysicsElements = {
  [T in Tag]: PhysicsTags[T]['attributes'] & {
    [Event in PhysicsTags[T]['events'] as \`on\${Event}\`]?: Listener<Event>;
  };
};

/** The same with listeners as \`on:collisionstart\`. */
export type PhysicsElementsOnColon = {
  [T in Tag]: PhysicsTags[T]['attributes'] & {
    [Event in PhysicsTags[T]['events'] as \`on:\${Event}\`]?: Listener<Event>;
  };
};

/** The same with listeners as \`onCollisionstart\`. */
export type PhysicsElementsOnCapital = {
  [T in Tag]: PhysicsTags[T]['attributes'] & {
    [Event in PhysicsTags[T]['events'] as \`on\${Capitalize<Event>}\`]?: Listener<Event>;
  };
};

/** As attributes of HTML are spelled. */
export type Lower<Attributes> = {
  [Name in keyof Attributes as Name extends string ? Lowercase<Name> : never]: Attributes[Name];
};
`;

const IMPORT = "import type * as Physics from './jsx.js';\n";

/** React says of camelCase at tags that it does not know that it does not know it, and takes \`size\` for a number. */
const REACT = `${IMPORT}import type { ClassAttributes, HTMLAttributes } from 'react';

type Html<Own, Element> = Own &
  Omit<HTMLAttributes<Element>, keyof Own> &
  ClassAttributes<Element> & { class?: string };

type Tags = {
  [Tag in keyof Physics.PhysicsTags]: Html<Physics.PhysicsElements[Tag], Physics.PhysicsTags[Tag]['element']>;
};
type Own<Tag extends keyof Physics.SceneTags> = Physics.Lower<Physics.SceneTags[Tag]>;
type SceneTags = {
  [Tag in keyof Physics.SceneTags]: Html<
    Omit<Own<Tag>, 'size'> & {
      /** React takes it for HTML's own, a single number, and leaves out what is none. */
      size?: 'React leaves size out: set it by ref, as in ref={(box) => box?.setAttribute("size", "1 1 1")}';
    },
    HTMLElement
  >;
};

declare module 'react' {
  namespace JSX {
    interface IntrinsicElements extends Tags, SceneTags {}
  }
}
`;

/** Preact takes both spellings, and listeners as they are called: `oncollisionstart`. */
const PREACT = `${IMPORT}import type { ClassAttributes, HTMLAttributes } from 'preact';

type Html<Own, Element extends EventTarget> = Own &
  Omit<HTMLAttributes<Element>, keyof Own> &
  ClassAttributes<Element>;

type Tags = {
  [Tag in keyof Physics.PhysicsTags]: Html<Physics.PhysicsElements[Tag], Physics.PhysicsTags[Tag]['element']>;
};
type SceneTags = {
  [Tag in keyof Physics.SceneTags]: Html<
    Physics.SceneTags[Tag] & Physics.Lower<Physics.SceneTags[Tag]>,
    HTMLElement
  >;
};

declare module 'preact' {
  namespace JSX {
    interface IntrinsicElements extends Tags, SceneTags {}
  }
}
`;

/** Solid sets properties, unless it is told otherwise. */
const SOLID = `${IMPORT}import type { JSX } from 'solid-js';

type Html<Own, Element> = Own & Omit<JSX.HTMLAttributes<Element>, keyof Own>;
type Told<Own> = {
  [Name in keyof Own & string as \`prop:\${Name}\`]?: Own[Name];
} & {
  [Name in keyof Own & string as \`attr:\${Name}\`]?: string | undefined;
} & {
  [Name in keyof Own & string as \`bool:\${Name}\`]?: boolean;
};

type Tags = {
  [Tag in keyof Physics.PhysicsTags]: Html<
    Physics.PhysicsElementsOnColon[Tag] & Told<Physics.PhysicsTags[Tag]['attributes']>,
    Physics.PhysicsTags[Tag]['element']
  >;
};
type SceneTags = {
  [Tag in keyof Physics.SceneTags]: Html<
    Physics.SceneTags[Tag] & Physics.Lower<Physics.SceneTags[Tag]>,
    HTMLElement
  >;
};

declare module 'solid-js' {
  namespace JSX {
    interface IntrinsicElements extends Tags, SceneTags {}
  }
}
`;

/** Svelte 5 listens by \`on…\`, Svelte 4 by \`on:…\`. */
const SVELTE = `${IMPORT}import type { HTMLAttributes } from 'svelte/elements';

type Html<Own, Element extends EventTarget> = Own & Omit<HTMLAttributes<Element>, keyof Own>;

type Tags = {
  [Tag in keyof Physics.PhysicsTags]: Html<
    Physics.PhysicsElements[Tag] & Physics.PhysicsElementsOnColon[Tag],
    Physics.PhysicsTags[Tag]['element']
  >;
};
type SceneTags = {
  [Tag in keyof Physics.SceneTags]: Html<
    Physics.SceneTags[Tag] & Physics.Lower<Physics.SceneTags[Tag]>,
    HTMLElement
  >;
};

declare module 'svelte/elements' {
  interface SvelteHTMLElements extends Tags, SceneTags {}
}
`;

/** Tags of the page's own, and no components: so each ref is the element, too. */
const VUE = `${IMPORT}import type { HTMLAttributes } from 'vue';

type Html<Own> = Own & Omit<HTMLAttributes, keyof Own>;

type Tags = { [Tag in keyof Physics.PhysicsTags]: Html<Physics.PhysicsElementsOnCapital[Tag]> };
type SceneTags = {
  [Tag in keyof Physics.SceneTags]: Html<
    Physics.SceneTags[Tag] & Physics.Lower<Physics.SceneTags[Tag]>
  >;
};

declare module 'vue' {
  interface IntrinsicElementAttributes extends Tags, SceneTags {}
}
`;

/** `jsx` has the interfaces and registers nothing; each framework's own file makes its templates know the tags. */
export function frameworkTypes(types: NodeType[], ui: readonly UIClass[]): Record<string, string> {
  const elements = [...types.map(({ name }) => `X3D${name}Element`), ...ui.map(({ name }) => name)];
  return {
    jsx: [
      head(elements),
      ...types.map(attributes),
      ...ui.map(uiAttributes),
      physicsTags(types, ui),
      TAIL,
    ].join('\n'),
    preact: PREACT,
    react: REACT,
    solid: SOLID,
    svelte: SVELTE,
    vue: VUE,
  };
}
