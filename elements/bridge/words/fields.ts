import { codecs, fromSI, SI, toSI, type Units } from '../../../physics-core/inside.js';
import { attribute, kebab, type Field, type NodeType } from './dom.js';

/** The attribute of a field: X3D's own name, kebab-case for our additions. */
export const attributeOf = (name: string, field: Field): string => (field.own ? kebab(name) : name);

/** Fields that hold nodes come from the structure of the document, not from values. */
export const holdsNodes = (field: Field): boolean =>
  field.type === 'SFNode' || field.type === 'MFNode';

/** A field of nodes of which the core makes nothing. */
export const isKept = ({ edit, nodes, access }: Field): boolean =>
  edit === 'passive' && !nodes && access.startsWith('in') && access !== 'inputOnly';

/** Other names of a field that real files have: X3D 3's prose spelled some in another way. */
const aliasesOf = (field: Field): readonly string[] => field.aliases ?? [];

/** All attributes that mean a field; ours by their property, too, as templates write what they take for one. */
export const attributeNames = (name: string, field: Field): string[] => [
  attributeOf(name, field),
  ...(field.own ? [name] : []),
  ...aliasesOf(field),
];

/** What the author wrote for a field, by any of its names. */
export function authoredText(element: Element, name: string, type: NodeType): string | undefined {
  const field = type.fields[name];
  for (const each of attributeNames(name, field)) {
    const text = attribute(element, each);
    if (text !== null) return text;
  }
  return undefined;
}

const byName = new WeakMap<NodeType, Map<string, string>>();

/** The field that a ROUTE or a prototype means: X3D lets `set_` and `_changed` stand around its name. */
export function fieldNamed(type: NodeType, name: string): string | undefined {
  let names = byName.get(type);
  if (!names) {
    names = new Map();
    for (const [field, entry] of Object.entries(type.fields))
      for (const each of [field, ...aliasesOf(entry)]) names.set(each, field);
    byName.set(type, names);
  }
  return names.get(name) ?? names.get(name.replace(/^set_/, '').replace(/_changed$/, ''));
}

const maps = new WeakMap<NodeType, Map<string, string>>();

/** Lowercase attribute name to field name. */
export function fieldsByAttribute(type: NodeType): Map<string, string> {
  let map = maps.get(type);
  if (!map) {
    map = new Map();
    for (const [name, field] of Object.entries(type.fields))
      for (const each of attributeNames(name, field)) map.set(each.toLowerCase(), name);
    maps.set(type, map);
  }
  return map;
}

/** A value in file units, or its text, as the core takes it: SI, or the text itself where it is malformed. */
export function inSI(field: Field, value: unknown, units: Units): unknown {
  const accepted = codecs[field.type].accept(value);
  return accepted === undefined ? value : toSI(field.type, accepted, field.dimension, units);
}

/** The same for the core's `set`, which reads a text itself: where nothing is to be scaled it gets what there is. */
export const forCore = (field: Field, value: unknown, units: Units): unknown =>
  field.dimension && units !== SI ? inSI(field, value, units) : value;

export const inFileUnits = (field: Field, value: unknown, units: Units): unknown =>
  fromSI(field.type, value, field.dimension, units);
