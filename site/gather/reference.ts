// The reference page of a node as Markdown, from the tables that the code runs on.
import { tagOf } from '../../elements/bridge/words/dom.js';
import { allTypes } from '../../physics-core/all-types.js';
import type { NodeType } from '../../physics-core/inside.js';
import {
  fieldSections,
  type FieldSection,
  type Row,
} from '../../stories/reference/field-sections.js';
import {
  interfaceSections,
  type InterfaceSection,
} from '../../stories/reference/interface-sections.js';
import { originOf } from '../../tools/build/origin.js';
import { storyOf } from './stories.js';

/** Text of the tables, which knows `code` and nothing else of Markdown. */
const plain = (text: string): string =>
  text
    .split('`')
    .map((part, i) =>
      i % 2 ? `\`${part}\`` : part.replace(/[\\*_[\]<>|{}]/g, (sign) => `&#${sign.charCodeAt(0)};`),
    )
    .join('');

const code = (text: string): string => (text ? `\`${text.replaceAll('|', '\\|')}\`` : '');

const also = (aliases: readonly string[]): string =>
  aliases.length ? ` Also ${aliases.map(code).join(', ')}.` : '';

/** A heading for each field: the site's search and links find it. */
function field({ name, type, access, aliases, doc, cells }: Row, heads: string[]): string {
  const facts = heads
    .map((head, i) => [head, cells[i]!] as const)
    .filter(([, text]) => text)
    .map(([head, text]) => `${head} ${head === 'Edit' || head === 'UNIT' ? text : code(text)}`);
  const line = [code(type), access, ...facts].join(' · ');
  return `### ${name} {#${name}}\n\n${plain(doc)}${also(aliases)}\n\n${line}\n{.facts}\n`;
}

const fields = ({ title, text, heads, rows }: FieldSection): string =>
  [`## ${title}\n\n${text}\n`, ...rows.map((row) => field(row, heads))].join('\n');

const members = ({ title, text, sentences }: InterfaceSection): string =>
  [
    `## ${title}\n\n${text}\n`,
    ...sentences.map(([name, meaning]) => `- \`${name}\`: ${plain(meaning)}`),
  ].join('\n');

function page(type: NodeType): string {
  const story = storyOf(type.name);
  return `---
title: ${type.name}
outline: [2, 3]
---

# ${type.name}

${plain(type.doc)}

\`<${tagOf(type)}>\` or \`<${type.name}>\`, ${originOf(type)}; it stands in its parent's \`${type.containerField}\`.

<iframe class="live story" loading="lazy" height="420" title="${type.name}, live" src="/stories/iframe.html?id=${story}&viewMode=story"></iframe>

[The example with its controls and its markup](/stories/index.html?path=/docs/${story.replace(/--.*/, '--docs')}){target="_self"}

${[...fieldSections(type).map(fields), ...interfaceSections(type).map(members)].join('\n\n')}
`;
}

export const referencePages = (): [name: string, text: string][] =>
  Object.values(allTypes).map((type) => [type.name, page(type)]);
