// What editors complete and explain: VS Code's custom data and JetBrains' web types, of the same elements.
import { readFileSync } from 'node:fs';
import { tagOf } from '../../elements/bridge/words/dom.js';
import { uiClasses } from '../../elements/define.js';
import type { NodeType } from '../../physics-core/inside.js';
import {
  attributesIn,
  cssProperties,
  eventsOf,
  propertiesOf,
  statesOf,
  types,
} from './manifest-elements.js';
import { attributesOf } from './manifest-fields.js';

const BOOLEAN = 'boolean';
const words = (values: readonly string[]) => values.filter(Boolean).map((name) => ({ name }));

/** The words that each attribute of a node takes, where it takes some only. */
function valuesOf(type: NodeType): Map<string, readonly string[]> {
  const named = attributesOf(type).filter(({ field }) => field.values);
  return new Map(named.map(({ attribute, field }) => [attribute, field.values!]));
}

function vscodeTag(type: NodeType) {
  const values = valuesOf(type);
  return {
    name: tagOf(type),
    description: type.doc,
    attributes: attributesIn(type).map(({ name, description, type: { text } }) => ({
      name,
      description,
      ...(text === BOOLEAN ? { valueSet: BOOLEAN } : {}),
      ...(values.has(name) ? { values: words(values.get(name)!) } : {}),
    })),
  };
}

export const vscodeData = () => ({
  version: 1.1,
  tags: [
    ...types.map(vscodeTag),
    ...uiClasses.map(({ tag, description: { doc, attributes } }) => ({
      name: tag,
      description: doc,
      attributes: attributes.map(({ name, doc: text }) => ({ name, description: text })),
    })),
  ],
  valueSets: [{ name: BOOLEAN, values: words(['true', 'false']) }],
});

const webElement = (type: NodeType) => ({
  name: tagOf(type),
  description: type.doc,
  attributes: attributesIn(type).map(({ name, description, type: { text } }) => ({
    name,
    description,
    value: { type: text },
    ...(text === BOOLEAN ? { required: false } : {}),
  })),
  js: {
    properties: propertiesOf(type).map(({ name, description, type: { text } }) => ({
      name,
      description,
      type: text,
    })),
    events: eventsOf(type).map(({ name, description }) => ({ name, description })),
  },
  css: {
    'pseudo-classes': statesOf(type).map(({ name, description }) => ({
      name: `state(${name})`,
      description,
    })),
  },
});

const webUI = ({ tag, description: { doc, attributes, parts } }: (typeof uiClasses)[number]) => ({
  name: tag,
  description: doc,
  attributes: attributes.map(({ name, doc: text, type }) => ({
    name,
    description: text,
    value: { type },
  })),
  css: {
    properties: cssProperties.map(({ name, description }) => ({ name, description })),
    parts: Object.entries(parts).map(([name, description]) => ({ name, description })),
  },
});

export function webTypes() {
  const { name, version } = JSON.parse(readFileSync('package.json', 'utf8')) as Record<
    string,
    string
  >;
  return {
    $schema: 'https://json.schemastore.org/web-types',
    name,
    version,
    'js-types-syntax': 'typescript',
    'description-markup': 'markdown',
    contributions: { html: { elements: [...types.map(webElement), ...uiClasses.map(webUI)] } },
  };
}
