// npm run manifest: dist/custom-elements.json, editor data and the types of properties, from the field tables alone.
import { appendFileSync, existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { tagOf } from '../elements/bridge/document/dom.js';
import { eventsAt, eventTypes } from '../elements/bridge/event-types.js';
import { nodeTypes, type Field, type NodeType } from '../physics-core/index.js';
import {
  additionsOf,
  attributesOf,
  defaultText,
  describe,
  fieldsOf,
  propertyType,
  settableType,
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

const types = Object.values(nodeTypes);

const manifest = {
  schemaVersion: '1.0.0',
  modules: types.map((type) => ({
    kind: 'javascript-module',
    path: `elements/${tagOf(type)}.js`,
    declarations: [declaration(type)],
    exports: [
      {
        kind: 'js',
        name: `X3D${type.name}Element`,
        declaration: { name: `X3D${type.name}Element` },
      },
    ],
  })),
};

const editorData = {
  version: 1.1,
  tags: types.map((type) => ({
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
};

function property(name: string, field: Field): string {
  const comment = `    /** ${describe(field)} Default ${defaultText(field) || 'none'}. */`;
  const type = propertyType(field);
  if (field.access === 'outputOnly') return `${comment}\n    readonly ${name}: ${type};`;
  if (field.access === 'inputOnly')
    return `${comment}\n    set ${name}(value: ${settableType(field)});`;
  return `${comment}\n    get ${name}(): ${type};\n    set ${name}(value: ${settableType(field)});`;
}

/** The properties that the element classes get from the tables at run time, but those that a class declares. */
const propertyTypes = types
  .map((type) => {
    const properties = fieldsOf(type)
      .filter(([name]) => !(type.name === 'CollisionCollection' && name === 'collidables'))
      .map(([name, field]) => property(name, field));
    return `declare module './${tagOf(type)}.js' {\n  interface X3D${type.name}Element {\n${properties.join('\n')}\n  }\n}`;
  })
  .join('\n\n');

mkdirSync('dist', { recursive: true });
writeFileSync('dist/custom-elements.json', JSON.stringify(manifest, null, 2));
writeFileSync('dist/vscode.html-custom-data.json', JSON.stringify(editorData, null, 2));
const INDEX = 'dist/types/elements/index.d.ts';
if (existsSync(INDEX)) {
  writeFileSync('dist/types/elements/properties.d.ts', `export {};\n\n${propertyTypes}\n`);
  appendFileSync(INDEX, "import './properties.js';\n");
  for (const [name, text] of Object.entries(frameworkTypes(types)))
    writeFileSync(`dist/types/${name}.d.ts`, text);
}
console.log(`${types.length} elements in dist/custom-elements.json`);
