// Files by pattern, with nothing but Node 20 (which has no glob of its own yet).
import { existsSync, readdirSync } from 'node:fs';

/** `**` crosses folders, `*` and `?` do not. */
function patternToRegExp(pattern) {
  const source = pattern
    .replace(/[.+^${}()|[\]\\]/g, '\\$&')
    .replace(/\*\*\/|\*|\?/g, (wild) => ({ '**/': '(?:.*/)?', '*': '[^/]*', '?': '[^/]' })[wild]);
  return new RegExp(`^${source}$`);
}

export const matches = (file, pattern) => patternToRegExp(pattern).test(file);

/** Files of the project (paths from its root, with `/`) that fit the pattern, sorted. */
export function globSync(pattern) {
  const folder = pattern.slice(0, pattern.search(/[*?]/)).replace(/[^/]*$/, '');
  if (!existsSync(folder)) return [];
  return readdirSync(folder, { recursive: true })
    .map((name) => folder + name.replaceAll('\\', '/'))
    .filter((file) => matches(file, pattern))
    .sort();
}
