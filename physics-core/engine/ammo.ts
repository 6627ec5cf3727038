import type AmmoModule from 'ammojs-typed/wasm';

/** The loaded Ammo module: Bullet 2.82 as WebAssembly, single precision. */
export type Ammo = typeof AmmoModule;
export type AmmoNamespace = Ammo;

export interface LoadOptions {
  /** Where ammo.wasm is. */
  wasmUrl?: string | undefined;
  /** The wasm itself, for pages opened from disk. */
  wasmBinary?: Uint8Array | undefined;
}

interface GlueOptions {
  locateFile?: () => string;
  wasmBinary?: Uint8Array;
  instantiateWasm?: (
    imports: WebAssembly.Imports,
    done: (instance: WebAssembly.Instance) => void,
  ) => object;
  onAbort?: (reason: unknown) => void;
}

type Glue = (this: object, options: GlueOptions) => Promise<Ammo>;

/**
 * Bytes of ammo.wasm. Fetched here and not by the glue, because the glue reports a missing file as an abort
 * of the whole module, long after, without the address.
 */
async function fetchWasm(url: string): Promise<Uint8Array> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url} answered ${response.status}`);
  return new Uint8Array(await response.arrayBuffer());
}

const inNode = typeof process === 'object' && !!process.versions?.node;

/** In Node the file is read; where it is not there (running from source) the glue finds its own. */
async function readWasm(url: string): Promise<Uint8Array | undefined> {
  const { readFile } = await import('node:fs/promises');
  return readFile(new URL(url)).catch(() => undefined);
}

/** By default the wasm lies beside the file this code is in. */
function wasmOf({ wasmUrl, wasmBinary }: LoadOptions): Promise<Uint8Array | undefined> {
  if (wasmBinary) return Promise.resolve(wasmBinary);
  const url = wasmUrl ?? new URL('./ammo.wasm', import.meta.url).href;
  return inNode && url.startsWith('file:') ? readWasm(url) : fetchWasm(url);
}

/** Loads a fresh Ammo module. The glue ends in `this.Ammo = …` and so needs a receiver. */
export async function loadAmmo(options: LoadOptions): Promise<Ammo> {
  const wasmBinary = await wasmOf(options);
  const { default: glue } = (await import('ammojs-typed/wasm')) as unknown as { default: Glue };
  return glue.call({}, wasmBinary ? { wasmBinary } : {});
}
