// What a node has beside its fields.
import { html } from 'lit';
import type { NodeType } from '../../physics-core/inside.js';
import { sentence } from './fields.js';
import { interfaceSections, type InterfaceSection } from './interface-sections.js';

const list = ({ title, text, sentences }: InterfaceSection) => html`
  <h2>${title}</h2>
  <p>${text}</p>
  <dl>
    ${sentences.map(
      ([name, meaning]) => html`
        <dt><code>${name}</code></dt>
        <dd>${sentence(meaning)}</dd>
      `,
    )}
  </dl>
`;

export const interfaceOf = (type: NodeType) => interfaceSections(type).map(list);
