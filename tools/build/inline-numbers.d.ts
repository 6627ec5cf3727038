import type { parseAst } from 'rollup/parseAst';

export function inlineNumbers(): {
  name: string;
  transform(
    this: { parse: typeof parseAst },
    code: string,
    id: string,
  ): { code: string; map: null } | null;
};
export function numbersOf(text: string): Map<string, string>;
