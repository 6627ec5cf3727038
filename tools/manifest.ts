// npm run manifest: dist/custom-elements.json, editor data and the types for frameworks, from the field tables and from
// what the classes of the ui say of themselves.
import { existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { camel, tagOf } from '../elements/bridge/words/dom.js';
import { eventsAt, eventTypes } from '../elements/bridge/words/event-types.js';
import { uiClasses } from '../elements/define.js';
import { nodeTypes, type NodeType } from '../physics-core/inside.js';
import {
  additionsOf,
  attributesOf,
  defaultText,
  describe,
  fieldsOf,
  propertyType,
} from './manifest-fields.js';
import { frameworkTypes } from './framework-types.js';

function declaration(type: NodeType) {
  return {
    kind: 'class',
    customElement: true,
    tagName: tagOf(type),
    name: `X3D${type.name}Element`,
    summary: type.doc,
    description: `${type.doc} ISO/IEC 19775-1, ${type.clause}.`,
    superclass: { name: 'HTMLElement' },
    attributes: [
      ...attributesOf(type).map(({ attribute, name, field }) => ({
        name: attribute,
        fieldName: name,
        type: { text: field.values?.map((value) => `"${value}"`).join(' | ') ?? field.type },
        default: defaultText(field),
        description: describe(field),
      })),
      ...additionsOf(type).map(({ attribute, property, type: text, doc }) => ({
        name: attribute,
        fieldName: property,
        type: { text },
        description: doc,
      })),
    ],
    members: [
      ...fieldsOf(type).map(([name, field]) => ({
        kind: 'field',
        name,
        type: { text: propertyType(field) },
        default: defaultText(field),
        description: describe(field),
        ...(field.access === 'outputOnly' ? { readonly: true } : {}),
      })),
      ...additionsOf(type).map(({ property, type: text, doc }) => ({
        kind: 'field',
        name: property,
        type: { text },
        description: doc,
      })),
    ],
    events: eventsAt(type.name).map((name) => ({
      name,
      type: { text: `CustomEvent<${eventTypes[name]!.detail}>` },
      description: eventTypes[name]!.doc,
    })),
  };
}

function uiDeclaration({ tag, name, description }: (typeof uiClasses)[number]) {
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
  };
}

const types = Object.values(nodeTypes);

const declarations = [...types.map(declaration), ...uiClasses.map(uiDeclaration)];

const manifest = {
  schemaVersion: '1.0.0',
  modules: declarations.map((each) => ({
    kind: 'javascript-module',
    path: `elements/${each.tagName}.js`,
    declarations: [each],
    exports: [{ kind: 'js', name: each.name, declaration: { name: each.name } }],
  })),
};

const editorData = {
  version: 1.1,
  tags: [
    ...types.map((type) => ({
      name: tagOf(type),
      description: type.doc,
      attributes: [
        ...attributesOf(type).map(({ attribute, field }) => ({
          name: attribute,
          description: describe(field),
          ...(field.values
            ? { values: field.values.filter(Boolean).map((value) => ({ name: value })) }
            : {}),
        })),
        ...additionsOf(type).map(({ attribute, doc }) => ({ name: attribute, description: doc })),
      ],
    })),
    ...uiClasses.map(({ tag, description: { doc, attributes } }) => ({
      name: tag,
      description: doc,
      attributes: attributes.map(({ name, doc: text }) => ({ name, description: text })),
    })),
  ],
};

mkdirSync('dist', { recursive: true });
writeFileSync('dist/custom-elements.json', JSON.stringify(manifest, null, 2));
writeFileSync('dist/vscode.html-custom-data.json', JSON.stringify(editorData, null, 2));
if (existsSync('dist/types')) {
  for (const [name, text] of Object.entries(frameworkTypes(types, uiClasses))) {
    writeFileSync(`dist/types/${name}.d.ts`, text);
    // Programs import them by name, and what they import must be there when they run.
    writeFileSync(`dist/types/${name}.js`, 'export {};\n');
  }
}
console.log(`${declarations.length} elements in dist/custom-elements.json`);
