/** A table before it is drawn: in a page, or in a text. */
export interface Table {
  head: readonly string[];
  rows: readonly (readonly string[])[];
}

/** In Markdown; the first column names the row, the others are numbers. */
export const markdownOf = ({ head, rows }: Table): string =>
  [head, head.map((_, i) => (i ? '---:' : '---')), ...rows]
    .map((cells) => `| ${cells.join(' | ')} |`)
    .join('\n');

/** In columns, for a terminal; the numbers, where there are any, to the right. */
export function columnsOf(rows: readonly (readonly string[])[], numbersFrom = Infinity): string {
  const widths = rows[0]!.map((_, i) => Math.max(...rows.map((row) => row[i]!.length)));
  const cell = (text: string, i: number) =>
    i < numbersFrom ? text.padEnd(widths[i]!) : text.padStart(widths[i]!);
  return rows.map((row) => row.map(cell).join('  ').trimEnd()).join('\n');
}
