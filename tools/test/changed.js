// Which files differ from what the branch goes back to: what has landed was checked when it did.
import { existsSync } from 'node:fs';
import { run } from '../processes.js';

async function git(...args) {
  const { ok, output } = await run('git', args, { quiet: true });
  return ok ? output.trim() : undefined;
}

/** Where the branch left the one that it follows; where it follows none, its last commit. */
const base = async () => (await git('merge-base', 'HEAD', '@{upstream}')) ?? 'HEAD';

/** Paths of files that are there; undefined where git knows nothing of them. */
export async function changedFiles() {
  const changed = await git('diff', '--name-only', await base());
  const untracked = await git('ls-files', '--others', '--exclude-standard');
  if (changed === undefined || untracked === undefined) return undefined;
  return [...changed.split('\n'), ...untracked.split('\n')].filter((file) => existsSync(file));
}
