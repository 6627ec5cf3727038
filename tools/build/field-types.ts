// TypeScript's side of the field tables: physics-core/face/fields.ts and elements/properties.ts.
import { tagOf } from '../../elements/bridge/words/dom.js';
import { eventTypes } from '../../elements/bridge/words/event-types.js';
import type { Field, NodeType } from '../../physics-core/inside.js';
import {
  additionsOf,
  defaultText,
  describe,
  fieldsOf,
  propertyType,
  givenType,
} from './manifest-fields.js';

const HEAD = '// Written by `npm run write -- types` from the tables in physics-core/nodes.\n';

const comment = (text: string): string => `/** ${text} */`;

const documented = (field: Field): string => {
  const text = defaultText(field);
  return comment(`${describe(field)}${text ? ` Default ${text}.` : ''}`);
};

const union = (words: readonly string[]): string => words.map((word) => `'${word}'`).join(' | ');

// ---- the core: values in SI units, nodes as handles -----------------------------------------------------------------

const GIVEN: Record<string, string> = {
  SFBool: 'boolean',
  SFFloat: 'number',
  SFInt32: 'number',
  SFTime: 'number',
  SFString: 'string',
  MFString: 'Strings',
  MFVec3f: 'NumberLists',
};

const READ: Record<string, string> = {
  ...GIVEN,
  SFVec2f: '[number, number]',
  SFVec3f: 'Vec3',
  SFRotation: 'Rotation',
  MFString: 'string[]',
  MFVec3f: 'Vec3[]',
};

const isGeometry = (types: readonly string[]): boolean => types.includes('Box');
const isPoints = (types: readonly string[]): boolean => types.includes('Coordinate');
const isLine = (types: readonly string[]): boolean => types.includes('LineSet');
const isCollidable = (types: readonly string[]): boolean =>
  types.length === 2 && types.every((type) => type.startsWith('Collidable'));

function given(field: Field): string {
  const { type, nodes, values, takesAll } = field;
  if (values) return union(values);
  if (type !== 'SFNode' && type !== 'MFNode') return GIVEN[type] ?? 'Numbers';
  if (!nodes) return 'unknown';
  const one = isGeometry(nodes)
    ? 'Geometry'
    : isPoints(nodes)
      ? 'Coordinate | NumberLists'
      : isLine(nodes)
        ? 'Line | NumberLists'
        : isCollidable(nodes)
          ? 'CollidableInput'
          : `NodeInput<${union(nodes)}>`;
  if (type === 'SFNode') return `${one} | null`;
  return `Several<${one}>${takesAll ? " | '*'" : ''}`;
}

function read({ type, nodes, values, takesAll }: Field): string {
  if (values) return union(values);
  if (type !== 'SFNode' && type !== 'MFNode') return READ[type] ?? 'number[]';
  if (!nodes) return 'unknown';
  const one = isGeometry(nodes)
    ? 'Geometry'
    : isPoints(nodes)
      ? 'Coordinate'
      : isLine(nodes)
        ? 'Line'
        : nodes.map((name) => `NodeHandles['${name}']`).join(' | ');
  if (type === 'SFNode') return `${one} | null`;
  return `(${one})[]${takesAll ? " | '*'" : ''}`;
}

const lines = (
  type: NodeType,
  leftOut: Field['access'],
  line: (name: string, field: Field) => string,
): string =>
  fieldsOf(type)
    .filter(([, { access }]) => access !== leftOut)
    .map(([name, field]) => line(name, field))
    .join('\n');

const coreTypes = (type: NodeType): string => `
/** What may be said of a ${type.name}${type.clause && ` (ISO/IEC 19775-1, ${type.clause})`}; what is left out has its default. */
export interface ${type.name}Fields {
${lines(type, 'outputOnly', (name, field) => `${documented(field)}\n${name}?: ${given(field)};`)}
}

/** What a ${type.name} answers. */
export interface ${type.name}Values {
${lines(type, 'inputOnly', (name, field) => `${name}: ${read(field)};`)}
}`;

const mapOf = (name: string, doc: string, types: readonly NodeType[], ending: string): string =>
  `\n${comment(doc)}\nexport interface ${name} {\n${types
    .map((type) => `${type.name}: ${type.name}${ending};`)
    .join('\n')}\n}`;

/** physics-core/face/fields.ts */
export const coreFieldTypes = (types: readonly NodeType[]): string =>
  [
    `${HEAD}import type { Rotation, Vec3 } from '../fields/types.js';
import type { Coordinate, Geometry, Line } from '../shapes/geometry.js';
import type { CollidableInput, NodeHandles, NodeInput } from './nodes.js';
import type { NumberLists, Numbers, Several, Strings } from './values.js';`,
    ...types.map(coreTypes),
    mapOf('NodeFields', 'What may be said of each type of node.', types, 'Fields'),
    mapOf('NodeValues', 'What each type of node answers.', types, 'Values'),
    `\n${comment("X3D's names of the types.")}\nexport type NodeName = keyof NodeFields;\n`,
  ].join('\n');

// ---- elements: values in the units of their file, nodes as elements -------------------------------------------------

function property(name: string, field: Field): string {
  const get = `get ${name}(): ${propertyType(field)};`;
  const taken = new Set([...givenType(name, field).split(' | '), 'null', 'undefined']);
  const set = `set ${name}(value: ${[...taken].join(' | ')});`;
  if (field.access === 'outputOnly') return `${documented(field)}\n${get}`;
  return `${documented(field)}\n${field.access === 'inputOnly' ? set : `${get}\n${set}`}`;
}

const elementTypes = (type: NodeType): string => `
/** Properties of \`<${tagOf(type)}>\`: read live, set to the text of the attribute, too; null takes script's word back. */
export interface ${type.name}Properties {
${fieldsOf(type)
  .map(([name, field]) => property(name, field))
  .join('\n')}
${additionsOf(type)
  .map(({ property: name, type: text, doc }) => `${comment(doc)}\n${name}: ${text};`)
  .join('\n')}
}`;

const eventMap = (): string => `
/** The events of all physics elements. They bubble, so that they can be listened to anywhere above. */
export interface PhysicsEventMap {
${Object.entries(eventTypes)
  .map(([name, { doc, detail }]) => `${comment(doc)}\n${name}: CustomEvent<${detail}>;`)
  .join('\n')}
}`;

/** elements/properties.ts */
export const elementPropertyTypes = (types: readonly NodeType[]): string =>
  [
    HEAD,
    ...types.map(elementTypes),
    mapOf('ElementProperties', 'By type of node.', types, 'Properties'),
    eventMap(),
    '',
  ].join('\n');
