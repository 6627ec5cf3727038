// The tables of a node's fields.
import { html, nothing } from 'lit';
import type { NodeType } from '../../physics-core/nodes/node/table.js';
import { fieldSections, type FieldSection, type Row } from './field-sections.js';

const cell = (label: string, text: string) => html`<td data-label=${label}>${text || nothing}</td>`;

/** `code` in the sentences of the tables. */
export const sentence = (text: string) =>
  text.split('`').map((part, i) => (i % 2 ? html`<code>${part}</code>` : part));

const row = ({ name, type, access, aliases, doc, cells }: Row, heads: string[]) => html`
  <tr>
    <th scope="row">
      <code>${name}</code>
      <small>${type} <span>${access}</span></small>
      ${aliases.length ? html`<small>also ${aliases.join(', ')}</small>` : nothing}
    </th>
    <td>${sentence(doc)}</td>
    ${cells.map((text, i) => cell(heads[i]!, text))}
  </tr>
`;

const table = ({ title, text, heads, rows }: FieldSection) => html`
  <h2>${title}</h2>
  <p>${text}</p>
  <table>
    <thead>
      <tr>
        ${['Field', 'Meaning', ...heads].map((head) => html`<th scope="col">${head}</th>`)}
      </tr>
    </thead>
    <tbody>
      ${rows.map((each) => row(each, heads))}
    </tbody>
  </table>
`;

export const fieldTables = (type: NodeType) => fieldSections(type).map(table);
