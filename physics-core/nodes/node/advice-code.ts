// The chunk `advice`.
import { nearest } from '../../base/nearest.js';
import type { Advice, AskedField, MeantNode } from './advice.js';
import { NODES, WORDS, type Word } from './words.js';

export const provide = (): Advice => ({ meant, meantNode });

/** Words are looked up without their hyphens and capitals. */
const plain = (name: string): string => name.toLowerCase().replace(/[-_]/g, '');

function meant(asked: AskedField, names: readonly string[]): string {
  const word = wordFor(asked, names);
  if (word) return answer(word, asked.type);
  const near = nearest(asked.name, names);
  return near ? `; did you mean ${near}?` : '';
}

/** What is near in letters to a field of the node itself comes before what is meant at another one. */
function wordFor({ name, type, value }: AskedField, names: readonly string[]): Word | undefined {
  const found = WORDS[plain(name)];
  const word = typeof found === 'function' ? found(typeof value === 'string' ? value : '') : found;
  if (!word || fits(word, type)) return word;
  return nearest(name, names) ? undefined : word;
}

const fits = ({ at }: Word, type: string): boolean => !at || at.test(type);

function answer(word: Word, type: string): string {
  const { field, write, does } = word;
  if (!fits(word, type)) return `; ${word.node} has ${field}${does ? `: ${does}` : ''}`;
  if (!does) return `; did you mean ${field}?`;
  return write ? `; write ${write}: ${does}` : `; ${does}`;
}

function meantNode(tag: string, types: readonly string[]): MeantNode | undefined {
  const name = plain(tag).replace(/^x3d/, '');
  const known = NODES[name];
  if (known) return known;
  const type = types.find((each) => plain(each) === name) ?? nearest(name, types);
  return type ? { type, does: '' } : undefined;
}
