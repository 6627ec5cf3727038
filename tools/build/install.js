import { existsSync, statSync, utimesSync } from 'node:fs';
import { npm } from '../processes.js';

const INSTALLED = 'node_modules/.package-lock.json';
const changed = (file) => statSync(file).mtimeMs;

/** Installs the packages where there are none, or where the lock file changed since. */
export async function ensurePackages() {
  if (existsSync(INSTALLED) && changed(INSTALLED) >= changed('package-lock.json')) return;
  console.log('Installing packages (npm ci) …');
  const { ok } = await npm(['ci']);
  if (!ok) throw new Error('npm ci failed: see above; the npm registry must be reachable.');
  // The lock file may be newer than the packages in it, and we would ask again each time.
  const now = new Date();
  utimesSync(INSTALLED, now, now);
}
