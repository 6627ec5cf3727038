// Addresses of stories. test/stories/reference.test.ts holds that each node has a story with its name as title.
import { readFileSync } from 'node:fs';
import { kebab } from '../../elements/bridge/words/dom.js';

/** The first story of a node's file, by the id that Storybook gives it. */
export function storyOf(node: string): string {
  const file = readFileSync(`stories/${kebab(node)}.stories.ts`, 'utf8');
  const [, first] = /export const (\w+): StoryObj/.exec(file)!;
  return `nodes-${node.toLowerCase()}--${kebab(first!)}`;
}
