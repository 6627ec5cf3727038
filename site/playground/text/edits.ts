// What was changed of a text, line by line: runs of lines that stayed, and lines that are new.
import { inOrder } from './in-order.js';

/** `[first, count]` of the old text's lines, or a new line. */
export type LineEdit = [first: number, count: number] | string;

export function editsBetween(before: string, after: string): LineEdit[] {
  const [old, fresh] = [before.split('\n'), after.split('\n')];
  const kept = keptLines(old, fresh);
  const edits: LineEdit[] = [];
  for (const [i, line] of fresh.entries()) {
    const at = kept.get(i);
    const run = edits.at(-1);
    if (at === undefined) edits.push(line);
    else if (Array.isArray(run) && run[0] + run[1] === at) run[1]++;
    else edits.push([at, 1]);
  }
  return edits;
}

export function withEdits(before: string, edits: readonly LineEdit[]): string {
  const old = before.split('\n');
  return edits
    .flatMap((edit) => (Array.isArray(edit) ? old.slice(edit[0], edit[0] + edit[1]) : [edit]))
    .join('\n');
}

/** By the place of a line in the new text the place that it had: of equal lines each is taken once, in order. */
function keptLines(old: readonly string[], fresh: readonly string[]): Map<number, number> {
  const places = new Map<string, number[]>();
  for (const [i, line] of old.entries()) places.set(line, [...(places.get(line) ?? []), i]);
  const found: [at: number, was: number][] = [];
  for (const [i, line] of fresh.entries()) {
    const was = places.get(line)?.shift();
    if (was !== undefined) found.push([i, was]);
  }
  const order = inOrder(found.map(([, was]) => was));
  return new Map(order.map((i) => found[i]!));
}
