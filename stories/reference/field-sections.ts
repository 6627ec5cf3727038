// The fields of a node as text, from the same table that the code runs on: for the reference pages here and in site/.
import { attributeOf } from '../../elements/bridge/words/fields.js';
import type { Dimension } from '../../physics-core/fields/types.js';
import type { Field, NodeType } from '../../physics-core/nodes/node/table.js';
import { defaultText, withPi } from './default-text.js';

const EDITS: Record<Field['edit'], string> = {
  live: 'in place',
  rebuild: 'made again',
  passive: 'when read',
};

const EXPONENTS: Record<number, string> = {
  1: '',
  2: '²',
  3: '³',
  [-1]: '⁻¹',
  [-2]: '⁻²',
  [-3]: '⁻³',
};

/** What the file's UNIT statements scale it by. */
const unitOf = (dimension: Dimension = {}): string =>
  Object.entries(dimension)
    .map(([name, power]) => name + EXPONENTS[power])
    .join(' × ');

const bound = (number: number): string =>
  Number.isFinite(number) ? withPi(String(number)) : number > 0 ? '∞' : '−∞';

function rangeOf({ range, open, values }: Field): string {
  if (values) return values.filter(Boolean).join(', ');
  if (!range) return '';
  const [low, high] = range;
  const left = open || !Number.isFinite(low) ? '(' : '[';
  return `${left}${bound(low)}, ${bound(high)}${Number.isFinite(high) ? ']' : ')'}`;
}

export interface Row {
  name: string;
  type: string;
  access: string;
  aliases: readonly string[];
  doc: string;
  /** Beneath the section's heads. */
  cells: string[];
}

export interface FieldSection {
  title: string;
  text: string;
  /** Of the columns after name and meaning. */
  heads: string[];
  rows: Row[];
}

const INPUT_HEADS = ['Default', 'Range', 'UNIT', 'Edit'];

const row = (name: string, field: Field, cells: string[]): Row => ({
  name: attributeOf(name, field),
  type: field.type,
  access: field.access,
  aliases: field.aliases ?? [],
  doc: field.doc,
  cells,
});

const cellsOf = (field: Field): string[] => [
  defaultText(field),
  rangeOf(field),
  unitOf(field.dimension),
  EDITS[field.edit],
];

type Entry = [string, Field];

const inputs = (title: string, text: string, fields: Entry[]): FieldSection => ({
  title,
  text,
  heads: INPUT_HEADS,
  rows: fields.map(([name, field]) => row(name, field, cellsOf(field))),
});

const outputs = (title: string, text: string, fields: Entry[]): FieldSection => ({
  title,
  text,
  heads: [],
  rows: fields.map(([name, field]) => row(name, field, [])),
});

/** All fields of a node: X3D's, its outputs, and ours. */
export function fieldSections(type: NodeType): FieldSection[] {
  const fields = Object.entries(type.fields as Record<string, Field>);
  const isOutput = ({ access }: Field) => access === 'outputOnly';
  const given = fields.filter(([, field]) => !isOutput(field));
  // Of a node that is ours all are.
  const isAdded = ({ own }: Field) => own && type.clause !== '';
  const names = type.clause
    ? 'Attribute and property have the name of the X3D field.'
    : 'The property is the same name in camel case, which is good for the attribute, too.';
  return [
    inputs(
      'Fields',
      `${names} UNIT: which UNIT statements of its file scale it; without any, the SI unit of the sentence holds. Edit: a running object is patched in place, or this one object is made again, or the value counts when something reads it.`,
      given.filter(([, field]) => !isAdded(field) && !field.common),
    ),
    outputs(
      'Outputs',
      'What the simulation answers: read the property, or ROUTE from the field.',
      fields.filter(([, field]) => isOutput(field)),
    ),
    inputs(
      'Additions',
      'Ours, not X3D’s. They work in both spellings; the property is the same name in camel case.',
      given.filter(([, field]) => isAdded(field)),
    ),
    inputs(
      'Common fields',
      'Of every node, or of all that have bounds; without meaning for physics.',
      given.filter(([, field]) => field.common),
    ),
  ].filter(({ rows }) => rows.length > 0);
}
