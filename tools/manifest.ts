// npm run manifest: dist/custom-elements.json, editor data and the types of properties, from the field tables alone.
import { appendFileSync, existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { tagOf } from '../elements/bridge/document/dom.js';
import { attributeOf, holdsNodes } from '../elements/bridge/nodes/fields.js';
import { codecs, nodeTypes, type Field, type NodeType } from '../physics-core/index.js';

const SCRIPT_TYPES: Record<string, string> = {
  SFBool: 'boolean',
  SFFloat: 'number',
  SFInt32: 'number',
  SFTime: 'number',
  SFString: 'string',
  MFString: 'string[]',
};
const scriptType = (field: Field): string => SCRIPT_TYPES[field.type] ?? 'number[]';

const rangeOf = ({ range, open }: Field): string =>
  range ? ` Range ${open ? '(' : '['}${range[0]}, ${range[1]}].` : '';
const describe = (field: Field): string => `${field.doc}${rangeOf(field)} (${field.type})`;
const defaultOf = (field: Field): string => codecs[field.type].format(field.default);

const settable = (type: NodeType): [string, Field][] =>
  Object.entries(type.fields as Record<string, Field>).filter(
    ([, field]) => !holdsNodes(field) && field.access !== 'outputOnly',
  );

function declaration(type: NodeType) {
  const fields = Object.entries(type.fields as Record<string, Field>).filter(
    ([, f]) => !holdsNodes(f),
  );
  return {
    kind: 'class',
    customElement: true,
    tagName: tagOf(type),
    name: `X3D${type.name}Element`,
    summary: type.doc,
    description: `${type.doc} ISO/IEC 19775-1, ${type.clause}.`,
    superclass: { name: 'HTMLElement' },
    attributes: settable(type).map(([name, field]) => ({
      name: attributeOf(name, field).toLowerCase(),
      fieldName: name,
      type: { text: field.values?.map((value) => `"${value}"`).join(' | ') ?? field.type },
      default: defaultOf(field),
      description: describe(field),
    })),
    members: fields.map(([name, field]) => ({
      kind: 'field',
      name,
      type: { text: scriptType(field) },
      default: defaultOf(field),
      description: describe(field),
      ...(field.access === 'outputOnly' ? { readonly: true } : {}),
    })),
    events: [
      {
        name: 'physicsproblem',
        type: { text: 'CustomEvent' },
        description: 'Something the author should know.',
      },
    ],
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
    attributes: settable(type).map(([name, field]) => ({
      name: attributeOf(name, field).toLowerCase(),
      description: describe(field),
      ...(field.values
        ? { values: field.values.filter(Boolean).map((value) => ({ name: value })) }
        : {}),
    })),
  })),
};

/** What a property takes: its value, the X3D text, and for numbers any list of them. */
const settableType = (field: Field): string => {
  const type = scriptType(field);
  if (type === 'string') return 'string';
  return `${type === 'number[]' ? 'ArrayLike<number> | readonly ArrayLike<number>[]' : type} | string`;
};

function property(name: string, field: Field): string {
  const comment = `    /** ${describe(field)} Default ${defaultOf(field) || 'none'}. */`;
  const type = field.type === 'MFVec3f' ? 'number[][]' : scriptType(field);
  if (field.access === 'outputOnly') return `${comment}\n    readonly ${name}: ${type};`;
  return `${comment}\n    get ${name}(): ${type};\n    set ${name}(value: ${settableType(field)});`;
}

/** The properties that the element classes get from the tables at run time. */
const propertyTypes = types
  .map((type) => {
    const properties = Object.entries(type.fields as Record<string, Field>)
      .filter(([, field]) => !holdsNodes(field))
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
}
console.log(`${types.length} elements in dist/custom-elements.json`);
