import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { join, relative, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { build, type Plugin } from 'esbuild';
import type * as Core from '../../../physics-core/create.js';
import { instrumented } from './instrument.js';
import { BULLET, recorder } from './recorder.js';

export type { Core };

const ROOT = resolve('physics-core');

const instrument: Plugin = {
  name: 'instrument',
  setup({ onLoad }) {
    onLoad({ filter: /[\\/]physics-core[\\/].*\.ts$/ }, ({ path }) => ({
      loader: 'ts',
      contents: instrumented(
        readFileSync(path, 'utf8'),
        relative(ROOT, path).replaceAll('\\', '/'),
      ),
    }));
  },
};

/** The face of the core, every function of which tells the recorder of its calls. */
export async function instrumentedCore(): Promise<typeof Core> {
  // Inside the project: what it imports of packages is looked for from there.
  const folder = mkdtempSync(join(resolve('node_modules'), '.walks-'));
  const outfile = join(folder, 'core.mjs');
  try {
    await build({
      entryPoints: ['physics-core/create.ts'],
      outfile,
      bundle: true,
      ignoreAnnotations: true,
      platform: 'node',
      target: 'node20',
      format: 'esm',
      packages: 'external',
      external: ['virtual:*'],
      plugins: [instrument],
      tsconfig: 'tsconfig.json',
      logLevel: 'warning',
    });
    Object.assign(globalThis, { walks: recorder });
    return (await import(pathToFileURL(outfile).href)) as typeof Core;
  } finally {
    rmSync(folder, { recursive: true });
  }
}

const listened = new WeakSet<object>();

/** What numbers are handed over in: no state of Bullet's. */
const ARGUMENT = /^bt(Vector|Quaternion|Transform)/;

/** From now on what this Ammo does is told, too, in all worlds that share it. */
export function listenToBullet(ammo: object): void {
  if (listened.has(ammo)) return;
  listened.add(ammo);
  // What is read often is its own, the classes are the glue's.
  for (const [type, value] of Object.entries(Object.getPrototypeOf(ammo) as object))
    if (/^bt/.test(type) && !ARGUMENT.test(type) && typeof value === 'function')
      tellMethods(type, value.prototype);
}

type Method = (this: unknown, ...values: unknown[]) => unknown;

function tellMethods(type: string, prototype: Record<string, unknown>): void {
  for (const [name, method] of Object.entries(prototype)) {
    // Ammo keeps a class as `constructor` and, minified, by one more name.
    if (typeof method !== 'function' || method === prototype.constructor) continue;
    prototype[name] = function (this: unknown, ...values: unknown[]) {
      recorder.enter(BULLET, `${type}.${name}`, this, values);
      try {
        return (method as Method).apply(this, values);
      } finally {
        recorder.exit();
      }
    };
  }
}
