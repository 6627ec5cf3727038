// What is said of the text, in words under it: a line for each, which leads to its place.
import type { Diagnostic } from '@codemirror/lint';

const WORDS = { error: 'Error', warning: 'Warning', info: 'Note', hint: 'Note' } as const;

export interface Line {
  /** Undefined: it is of no place in the text. */
  number: number | undefined;
  diagnostic: Diagnostic;
}

/** What stays keeps its element: readers of the page by ear hear what is new, and nothing else. */
export function showTold(
  list: HTMLElement,
  lines: readonly Line[],
  goTo: (diagnostic: Diagnostic) => void,
): void {
  const there = new Map([...list.children].map((item) => [keyOf(item), item]));
  const items = lines.map((line) => there.get(textOf(line)) ?? itemOf(line));
  for (const item of there.values()) if (!items.includes(item)) item.remove();
  for (const [i, item] of items.entries()) {
    if (list.children[i] !== item) list.insertBefore(item, list.children[i] ?? null);
    const { diagnostic } = lines[i]!;
    const button = item.querySelector('button');
    if (button) button.onclick = () => goTo(diagnostic);
  }
}

const keyOf = (item: Element): string => item.textContent;

const textOf = ({ number, diagnostic: { severity, message } }: Line): string =>
  `${WORDS[severity]}${number === undefined ? '' : ` in line ${number}`}: ${message}`;

function itemOf(line: Line): Element {
  const item = document.createElement('li');
  const words = document.createElement(line.number === undefined ? 'span' : 'button');
  if (words instanceof HTMLButtonElement) words.type = 'button';
  const [head] = textOf(line).split(': ', 1);
  const strong = document.createElement('strong');
  strong.textContent = `${head}:`;
  words.append(strong, textOf(line).slice(strong.textContent.length));
  item.className = line.diagnostic.severity;
  item.append(words);
  return item;
}
