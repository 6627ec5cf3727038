// Types of all tags for the templates of frameworks, from the field tables and from what the ui says of itself.
import { camel, tagOf } from '../elements/bridge/words/dom.js';
import { eventsAt, eventTypes } from '../elements/bridge/words/event-types.js';
import type { UIDescription } from '../elements/ui/ui-element.js';
import type { NodeType } from '../physics-core/inside.js';
import { additionsOf, attributesOf, describe, settableType } from './manifest-fields.js';

const quote = (name: string): string => (/^\w+$/.test(name) ? name : `'${name}'`);

/** By property name, since frameworks set properties where there are any; and by attribute. */
function properties(type: NodeType): string[] {
  const fields = attributesOf(type).flatMap(({ attribute, name, field }) => {
    const line = (key: string): string =>
      `  /** ${describe(field)} */\n  ${quote(key)}?: ${settableType(field)};`;
    return attribute === name ? [line(name)] : [line(name), line(attribute)];
  });
  const additions = additionsOf(type).flatMap(({ attribute, type: text, doc }) =>
    [...new Set([attribute, camel(attribute)])].map(
      (key) => `  /** ${doc} */\n  ${quote(key)}?: ${text};`,
    ),
  );
  return [...fields, ...additions];
}

const attributes = (type: NodeType): string =>
  `export interface ${type.name}Attributes extends PhysicsAttributes {\n${properties(type).join('\n')}\n}`;

/** An element of the ui: it has no node. */
export interface UIClass {
  readonly tag: string;
  readonly description: UIDescription;
}

const uiName = ({ tag }: UIClass): string => {
  const name = camel(tag.replace('x3d-', ''));
  return `${name[0]!.toUpperCase()}${name.slice(1)}Attributes`;
};

function uiAttributes(element: UIClass): string {
  const lines = element.description.attributes.map(
    ({ name, type, doc }) => `  /** ${doc} */\n  ${quote(name)}?: ${type};`,
  );
  return `export interface ${uiName(element)} extends PhysicsAttributes {\n${lines.join('\n')}\n}`;
}

type Naming = (event: string) => string;

const events = (type: NodeType, name: Naming): string =>
  eventsAt(type.name)
    .map(
      (each) => `${quote(name(each))}?: (event: CustomEvent<${eventTypes[each]!.detail}>) => void`,
    )
    .join('; ');

/** One entry per tag; `name` is how the framework calls the listener of an event. */
const tags = (types: NodeType[], name: Naming): string =>
  types
    .map((type) => `  '${tagOf(type)}': ${type.name}Attributes & { ${events(type, name)} };`)
    .join('\n');

const HEAD = `/** What every physics tag takes, in templates. */
export interface PhysicsAttributes {
  id?: string;
  class?: string;
  slot?: string;
  def?: string;
  use?: string;
  containerfield?: string;
  key?: unknown;
  ref?: unknown;
  children?: unknown;
  [data: \`data-\${string}\`]: unknown;
}
`;

const on: Naming = (event) => `on${event}`;
const onColon: Naming = (event) => `on:${event}`;
const onCapital: Naming = (event) => `on${event[0]!.toUpperCase()}${event.slice(1)}`;

const augment = (module: string, inside: string, before = ''): string =>
  `import type * as Physics from './jsx.js';\nimport '${module}';\n${before}\ndeclare module '${module}' {\n${inside}\n}\n`;

/** Svelte 5 listens by `on…`, Svelte 4 by `on:…`. */
const SVELTE = `
type On = Physics.PhysicsElements;
type Tags = { [Tag in keyof On]: On[Tag] & Physics.PhysicsElementsOnColon[Tag] };
`;
const VUE = `
type On = Physics.PhysicsElementsOnCapital;
type Tags = { [Tag in keyof On]: new () => { $props: On[Tag] } };
`;

/** `jsx` has the interfaces and registers nothing; each framework's own file makes its templates know the tags. */
export function frameworkTypes(types: NodeType[], ui: readonly UIClass[]): Record<string, string> {
  const uiTags = ui.map((element) => `  '${element.tag}': ${uiName(element)};`).join('\n');
  const all = (name: string, naming: Naming): string =>
    `export interface ${name} {\n${tags(types, naming)}\n${uiTags}\n}\n`;
  return {
    jsx: [
      HEAD,
      ...types.map(attributes),
      ...ui.map(uiAttributes),
      all('PhysicsElements', on),
      all('PhysicsElementsOnColon', onColon),
      all('PhysicsElementsOnCapital', onCapital),
    ].join('\n'),
    react: augment(
      'react',
      '  namespace JSX {\n    interface IntrinsicElements extends Physics.PhysicsElements {}\n  }',
    ),
    solid: augment(
      'solid-js',
      '  namespace JSX {\n    interface IntrinsicElements extends Physics.PhysicsElementsOnColon {}\n  }',
    ),
    svelte: augment('svelte/elements', '  interface SvelteHTMLElements extends Tags {}', SVELTE),
    vue: augment('vue', '  interface GlobalComponents extends Tags {}', VUE),
  };
}
