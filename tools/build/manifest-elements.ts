// dist/custom-elements.json: each element with its attributes, members, events, states, and what styles see of it.
import { readFileSync } from 'node:fs';
import { camel, tagOf } from '../../elements/bridge/words/dom.js';
import { eventsAt, eventTypes } from '../../elements/bridge/words/event-types.js';
import { uiClasses } from '../../elements/define.js';
import { allTypes } from '../../physics-core/all-types.js';
import type { NodeType } from '../../physics-core/inside.js';
import {
  additionsOf,
  attributesOf,
  attributeType,
  defaultText,
  describe,
  fieldsOf,
  propertyType,
} from './manifest-fields.js';
import { membersIn } from './manifest-methods.js';

export type UIClass = (typeof uiClasses)[number];

export const types: readonly NodeType[] = Object.values(allTypes);

/** X3D's own, which say where a node stands; they are no fields. */
export const NAMING = [
  { name: 'def', doc: 'The name by which references, ROUTEs and `use` mean it.' },
  { name: 'use', doc: 'The name of another element that it stands for.' },
  { name: 'containerfield', doc: 'The field of its parent that it stands in.' },
];

const STATES: Record<string, string> = {
  problem: 'The library has told of something wrong with it.',
  waiting: 'It waits for what it names.',
  sleeping: 'It has come to rest.',
  colliding: 'It touches something, and somebody listens to its collisions.',
  dragging: 'Somebody holds it.',
};

export function statesOf({ name }: NodeType): { name: string; description: string }[] {
  const own = name === 'RigidBody' ? ['sleeping', 'colliding'] : [];
  if (name === 'RigidBody' || SOFT.includes(name)) own.push('dragging');
  return ['problem', 'waiting', ...own].map((state) => ({
    name: state,
    description: STATES[state]!,
  }));
}

export const eventsOf = ({ name }: NodeType) =>
  eventsAt(name).map((event) => ({
    name: event,
    type: { text: `CustomEvent<${eventTypes[event]!.detail}>` },
    description: eventTypes[event]!.doc,
  }));

const NODE_MEMBERS = membersIn('elements/node-element.ts');
const BODY_MEMBERS = membersIn('elements/body-element.ts');
const SOFT_MEMBERS = membersIn('elements/soft-element.ts');

/** What people take by hand beside bodies. */
const SOFT = ['Rope', 'Cloth', 'SoftBody'];

const membersOf = ({ name }: NodeType) => [
  ...NODE_MEMBERS,
  ...(name === 'RigidBody' ? BODY_MEMBERS : []),
  ...(SOFT.includes(name) ? SOFT_MEMBERS : []),
];

export const attributesIn = (type: NodeType) => [
  ...NAMING.map(({ name, doc }) => ({ name, type: { text: 'string' }, description: doc })),
  ...attributesOf(type).map(({ attribute, name, field }) => ({
    name: attribute,
    fieldName: name,
    type: { text: attributeType(field) },
    default: defaultText(field),
    description: describe(field),
  })),
  ...additionsOf(type).map(({ attribute, property, type: text, doc }) => ({
    name: attribute,
    fieldName: property,
    type: { text },
    description: doc,
  })),
];

export const propertiesOf = (type: NodeType) => [
  ...fieldsOf(type).map(([name, field]) => ({
    kind: 'field' as const,
    name,
    type: { text: propertyType(field) },
    default: defaultText(field),
    description: describe(field),
    ...(field.access === 'outputOnly' ? { readonly: true } : {}),
  })),
  ...additionsOf(type).map(({ property, type: text, doc }) => ({
    kind: 'field' as const,
    name: property,
    type: { text },
    description: doc,
  })),
];

const declaration = (type: NodeType) => ({
  kind: 'class',
  customElement: true,
  tagName: tagOf(type),
  name: `X3D${type.name}Element`,
  summary: type.doc,
  description: type.clause ? `${type.doc} ISO/IEC 19775-1, ${type.clause}.` : type.doc,
  superclass: { name: 'HTMLElement' },
  attributes: attributesIn(type),
  members: [...propertiesOf(type), ...membersOf(type)],
  events: eventsOf(type),
  cssStates: statesOf(type),
});

/** Colours that pages give to elements of the ui: they stand in their style sheet, with what is used otherwise. */
export const cssProperties = [
  ...readFileSync('styles/ui.css', 'utf8').matchAll(/var\((--x3d-ui-(\w+)), (.+)\);/g),
].map(([, name, what, otherwise]) => ({
  name: name!,
  syntax: '<color>',
  default: otherwise!,
  description: `Colour: ${what}.`,
}));

function uiDeclaration({ tag, name, description }: UIClass) {
  const { doc, attributes, parts } = description;
  const described = (each: (typeof attributes)[number]) => ({
    name: each.name,
    type: { text: each.type },
    default: each.default,
    description: each.doc,
  });
  return {
    kind: 'class',
    customElement: true,
    tagName: tag,
    name,
    summary: doc,
    superclass: { name: 'HTMLElement' },
    attributes: attributes.map((each) => ({ ...described(each), fieldName: camel(each.name) })),
    members: attributes.map((each) => ({
      ...described(each),
      kind: 'field',
      name: camel(each.name),
    })),
    cssParts: Object.entries(parts).map(([part, text]) => ({ name: part, description: text })),
    cssProperties,
    cssStates: [{ name: 'problem', description: STATES.problem! }],
  };
}

const ENTRY = 'dist/x3d-physics.js';

/** The whole of it; paths are those of the package. */
export function manifest() {
  const declarations = [...types.map(declaration), ...uiClasses.map(uiDeclaration)];
  const pathOf = (tag: string): string => `dist/elements/${tag}.js`;
  return {
    schemaVersion: '2.1.0',
    modules: [
      {
        kind: 'javascript-module',
        path: ENTRY,
        description: 'Defines all elements.',
        declarations: [],
        exports: declarations.map(({ tagName, name }) => ({
          kind: 'custom-element-definition',
          name: tagName,
          declaration: { name, module: pathOf(tagName) },
        })),
      },
      ...declarations.map((each) => ({
        kind: 'javascript-module',
        path: pathOf(each.tagName),
        declarations: [each],
        exports: [{ kind: 'js', name: each.name, declaration: { name: each.name } }],
      })),
    ],
  };
}
