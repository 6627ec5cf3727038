import { codecs, fromSI, toSI, type Units } from '../../../physics-core/index.js';
import { kebab, type Field, type NodeType } from '../document/dom.js';

/** The attribute of a field: X3D's own name, kebab-case for our additions. */
export const attributeOf = (name: string, field: Field): string => (field.own ? kebab(name) : name);

/** Fields that hold nodes come from the structure of the document, not from values. */
export const holdsNodes = (field: Field): boolean =>
  field.type === 'SFNode' || field.type === 'MFNode';

const maps = new WeakMap<NodeType, Map<string, string>>();

/** Lowercase attribute name to field name. */
export function fieldsByAttribute(type: NodeType): Map<string, string> {
  let map = maps.get(type);
  if (!map) {
    const entries = Object.entries(type.fields);
    map = new Map(entries.map(([name, field]) => [attributeOf(name, field).toLowerCase(), name]));
    maps.set(type, map);
  }
  return map;
}

/** A value in file units, or its text, as the core takes it: SI, or the text itself where it is malformed. */
export function inSI(field: Field, value: unknown, units: Units): unknown {
  const accepted = codecs[field.type].accept(value);
  return accepted === undefined ? value : toSI(field.type, accepted, field.dimension, units);
}

export const inFileUnits = (field: Field, value: unknown, units: Units): unknown =>
  fromSI(field.type, value, field.dimension, units);
