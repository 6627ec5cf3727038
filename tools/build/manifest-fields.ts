// What the manifest, the editor data and the framework types say of one field.
import { STRUCTURE } from '../../elements/bridge/words/attributes.js';
import { camel } from '../../elements/bridge/words/dom.js';
import { attributeOf, holdsNodes } from '../../elements/bridge/words/fields.js';
import { codecs, type Field, type NodeType } from '../../physics-core/inside.js';

const SCRIPT_TYPES: Record<string, string> = {
  SFBool: 'boolean',
  SFFloat: 'number',
  SFInt32: 'number',
  SFTime: 'number',
  SFString: 'string',
  MFString: 'string[]',
  MFVec3f: 'number[][]',
  SFNode: 'Element | null',
  MFNode: 'Element[]',
};

/** Contacts are plain objects, since no element stands for them. */
const holdsContacts = (field: Field): boolean => field.nodes?.includes('Contact') ?? false;

/** What reading the property gives. */
export const propertyType = (field: Field): string =>
  holdsContacts(field)
    ? 'Record<string, unknown>[]'
    : `${SCRIPT_TYPES[field.type] ?? 'number[]'}${field.takesAll ? " | '*'" : ''}`;

const PLAIN = new Set(['boolean', 'number']);

/** What stands in the attribute. */
export function attributeType(field: Field): string {
  if (field.values) return field.values.map((value) => `"${value}"`).join(' | ');
  const type = SCRIPT_TYPES[field.type] ?? 'string';
  return PLAIN.has(type) ? type : 'string';
}

/** What a property takes: its value, the X3D text, and for numbers any list of them. */
export function settableType(field: Field): string {
  if (holdsContacts(field)) return 'Iterable<Element | Record<string, unknown>>';
  if (field.type === 'SFNode') return 'Element | null';
  if (field.type === 'MFNode')
    return `Iterable<Element> | ${field.takesAll ? 'string | ' : ''}null`;
  const type = SCRIPT_TYPES[field.type] ?? 'number[]';
  if (type === 'string') return 'string';
  const list = type.startsWith('number[]');
  return `${list ? 'ArrayLike<number> | readonly ArrayLike<number>[]' : type} | string`;
}

const rangeOf = ({ range, open }: Field): string =>
  range ? ` Range ${open ? '(' : '['}${range[0]}, ${range[1]}].` : '';
export const describe = (field: Field): string => `${field.doc}${rangeOf(field)} (${field.type})`;
export const defaultText = (field: Field): string =>
  holdsNodes(field) ? '' : codecs[field.type].format(field.default);

export const fieldsOf = (type: NodeType): [string, Field][] =>
  Object.entries(type.fields as Record<string, Field>);

/** Fields that hold nodes and may be written as text: names, or `*`. */
const NAMED_NODES = /^body[12]$/;
const isWritten = (name: string, field: Field): boolean =>
  !holdsNodes(field) || field.takesAll === true || NAMED_NODES.test(name);

/** What templates give: nodes that may be written as text, too, by their names. */
export const givenType = (name: string, field: Field): string =>
  NAMED_NODES.test(name) ? `${settableType(field)} | string` : settableType(field);

export interface Attribute {
  attribute: string;
  name: string;
  field: Field;
}

export const attributesOf = (type: NodeType): Attribute[] =>
  fieldsOf(type)
    .filter(([name, field]) => isWritten(name, field))
    .filter(([, { access }]) => access !== 'outputOnly' && access !== 'inputOnly')
    .map(([name, field]) => ({
      attribute: attributeOf(name, field).toLowerCase(),
      name,
      field,
    }));

const ADDITIONS: Record<string, { type: string; doc: string }> = {
  for: { type: 'string', doc: 'DEF or id of the Transform, Shape or group that it stands for.' },
  default: { type: 'boolean', doc: 'It gives the default world of its x3d element its fields.' },
  'shared-world': {
    type: 'string',
    doc: 'Collections of one x3d element with the same name here share a world.',
  },
  batch: {
    type: 'boolean',
    doc: 'Whether bodies are drawn in one call with others that look alike; "false": by themselves.',
  },
};

/** Attributes of ours that are no fields, and properties that reflect them. */
export const additionsOf = (type: NodeType) =>
  (STRUCTURE[type.name] ?? []).map((attribute) => ({
    attribute,
    property: camel(attribute),
    ...ADDITIONS[attribute]!,
  }));
