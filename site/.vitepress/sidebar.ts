// What stands where in the site's menu.
import type { DefaultTheme } from 'vitepress';

type Item = DefaultTheme.SidebarItem;

const pages = (folder: string, entries: Record<string, string>): Item[] =>
  Object.entries(entries).map(([name, text]) => ({ text, link: `/${folder}/${name}` }));

export const sidebar = (nodes: string[]): Item[] => [
  { text: 'Guide', items: pages('guide', { 'which-file': 'Which file' }) },
  ...(nodes.length
    ? [{ text: 'Reference', items: nodes.map((text) => ({ text, link: `/reference/${text}` })) }]
    : []),
  {
    text: 'How it works',
    items: pages('docs', {
      edits: 'Edits of a running scene',
      joints: 'Joints that do not stretch',
      contacts: 'Contacts that hold',
      stability: 'What stays stable',
      effects: 'Effects',
      chunks: 'Files',
      drawing: 'Drawing many bodies',
      pages: 'In real pages',
      conformance: 'Conformance',
    }),
  },
  { text: 'Changelog', link: '/changelog' },
];
