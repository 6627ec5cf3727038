// The table of a node's fields, from the same table that the code runs on.
import { html, nothing } from 'lit';
import { attributeOf } from '../../elements/bridge/words/fields.js';
import type { Dimension } from '../../physics-core/fields/types.js';
import type { Field, NodeType } from '../../physics-core/nodes/node/table.js';
import { defaultText, withPi } from './default-text.js';

const EDITS: Record<Field['edit'], string> = {
  live: 'in place',
  rebuild: 'made again',
  passive: 'when read',
};

const EXPONENTS: Record<number, string> = { 1: '', 2: '²', 3: '³', [-1]: '⁻¹', [-2]: '⁻²' };

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

const cell = (label: string, text: string) => html`<td data-label=${label}>${text || nothing}</td>`;

/** `code` in the sentences of the tables. */
export const sentence = (text: string) =>
  text.split('`').map((part, i) => (i % 2 ? html`<code>${part}</code>` : part));

const row = (name: string, field: Field) => html`
  <tr>
    <th scope="row">
      <code>${attributeOf(name, field)}</code>
      <small>${field.type} <span>${field.access}</span></small>
      ${field.aliases ? html`<small>also ${field.aliases.join(', ')}</small>` : nothing}
    </th>
    <td>${sentence(field.doc)}</td>
    ${
      field.access === 'outputOnly'
        ? nothing
        : [
            cell('Default', defaultText(field)),
            cell('Range', rangeOf(field)),
            cell('UNIT', unitOf(field.dimension)),
            cell('Edit', EDITS[field.edit]),
          ]
    }
  </tr>
`;

const INPUT_HEADS = ['Default', 'Range', 'UNIT', 'Edit'];

const table = (title: string, text: string, rows: [string, Field][], heads: string[]) =>
  rows.length === 0
    ? nothing
    : html`
        <h2>${title}</h2>
        <p>${text}</p>
        <table>
          <thead>
            <tr>
              ${['Field', 'Meaning', ...heads].map((head) => html`<th scope="col">${head}</th>`)}
            </tr>
          </thead>
          <tbody>
            ${rows.map(([name, field]) => row(name, field))}
          </tbody>
        </table>
      `;

/** All fields of a node: X3D's, its outputs, and ours. */
export function fieldTables(type: NodeType) {
  const fields = Object.entries(type.fields as Record<string, Field>);
  const inputs = fields.filter(([, field]) => field.access !== 'outputOnly');
  const outputs = fields.filter(([, field]) => field.access === 'outputOnly');
  const own = inputs.filter(([, field]) => field.own);
  const common = inputs.filter(([, field]) => field.common);
  const x3d = inputs.filter(([, field]) => !field.own && !field.common);
  return [
    table(
      'Fields',
      'Attribute and property have the name of the X3D field. UNIT: which UNIT statements of its file scale it; without any, the SI unit of the sentence holds. Edit: a running object is patched in place, or this one object is made again, or the value counts when something reads it.',
      x3d,
      INPUT_HEADS,
    ),
    table(
      'Outputs',
      'What the simulation answers: read the property, or ROUTE from the field.',
      outputs,
      [],
    ),
    table(
      'Additions',
      'Ours, not X3D’s. They work in both spellings; the property is the same name in camel case.',
      own,
      INPUT_HEADS,
    ),
    table(
      'Common fields',
      'Of every node, or of all that have bounds; without meaning for physics.',
      common,
      INPUT_HEADS,
    ),
  ];
}
