// The reference page of one node: what it is, a live example, its markup, its fields.
import { originOf } from '../../tools/build/origin.js';
import { html, nothing, type TemplateResult } from 'lit';
import { tagOf } from '../../elements/bridge/words/dom.js';
import { allTypes } from '../../physics-core/all-types.js';
import { playgroundAddress } from '../../site/playground/address.js';
import { copyable } from '../copyable.js';
import { fieldTables } from './fields.js';
import { interfaceOf } from './interface.js';
import { markupOf } from './markup.js';

/** Tags of physics nodes, in both spellings. */
const PHYSICS = new RegExp(`(</?(?:x3d-|${Object.keys(allTypes).join('\\b|')}\\b)[^>]*>)`);

/** Physics stands out from what only draws. */
const highlighted = (text: string) =>
  text.split(PHYSICS).map((part, i) => (i % 2 ? html`<b>${part}</b>` : part));

/** The stories lie within the site; by themselves they have no playground beside them. */
const isInSite = (): boolean => new URL('.', location.href).pathname.endsWith('/stories/');

const toPlayground = (markup: string) =>
  html`<p><a href=${playgroundAddress(markup, '../')} target="_top">Open in the playground</a></p>`;

const SCRIPT = 'Its script';

const code = (summary: string, text: string, open = false) => html`
  <details ?open=${open}>
    <summary>${summary}</summary>
    ${copyable(highlighted(text))}
    ${summary !== SCRIPT && isInSite() ? toPlayground(text) : nothing}
  </details>
`;

/** `title` is `Nodes/RigidBody`; `id` is the example's, as addresses have it; `script` its page code. */
export function referencePage(
  title: string,
  id: string,
  example: TemplateResult,
  script: string | undefined,
) {
  const type = allTypes[title.split('/').at(-1)!]!;
  const text = markupOf(example);
  return html`
    <article class="reference">
      <h1>${type.name}</h1>
      <p class="lead">${type.doc}</p>
      <p>
        <code>&lt;${tagOf(type)}&gt;</code> or <code>&lt;${type.name}&gt;</code>, ${originOf(type)};
        it stands in its parent's <code>${type.containerField}</code>.
      </p>
      <iframe src="iframe.html?id=${id}&viewMode=story" title="${type.name}, live"></iframe>
      <p><a href="./?path=/story/${id}" target="_top">The example with its controls</a></p>
      ${code('Its markup, in HTML', text.custom, true)} ${code('The same as plain X3D', text.plain)}
      ${script ? code(SCRIPT, script) : nothing} ${fieldTables(type)} ${interfaceOf(type)}
    </article>
  `;
}
