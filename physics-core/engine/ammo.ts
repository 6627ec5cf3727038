import type AmmoModule from 'ammojs-typed/wasm';

/** The loaded Ammo module: Bullet 2.82 as WebAssembly, single precision. */
export type Ammo = typeof AmmoModule;
export type AmmoNamespace = Ammo;

export interface LoadOptions {
  /** Where ammo.wasm is. */
  wasmUrl?: string | undefined;
  /** The wasm itself, for pages opened from disk. */
  wasmBinary?: Uint8Array | undefined;
  /** The wasm compiled: another engine's. */
  program?: WebAssembly.Module | undefined;
  /** Where accuracy-worker.js is. */
  workerUrl?: string | undefined;
}

interface GlueOptions {
  instantiateWasm?: (
    imports: WebAssembly.Imports,
    done: (instance: WebAssembly.Instance) => void,
  ) => object;
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

/** What went wrong, and with which file: the network's own errors and the compiler's name none. */
function failure({ wasmUrl, wasmBinary }: LoadOptions, error: unknown): Error {
  const what = error instanceof Error ? error.message : String(error);
  if (wasmBinary || !wasmUrl || what.includes(wasmUrl)) return new Error(what, { cause: error });
  return new Error(`${wasmUrl}: ${what}`, { cause: error });
}

/** Compiled once, it serves any number of Ammo modules; undefined where the glue finds its own (Node running from source). */
export async function compileAmmo(options: LoadOptions): Promise<WebAssembly.Module | undefined> {
  if (options.program) return options.program;
  try {
    const bytes = await wasmOf(options);
    return bytes && (await WebAssembly.compile(bytes as BufferSource));
  } catch (error) {
    throw failure(options, error);
  }
}

/** Loads a fresh Ammo module, with a heap of its own. The glue ends in `this.Ammo = …` and so needs a receiver. */
export async function loadAmmo(program: WebAssembly.Module | undefined): Promise<Ammo> {
  const { default: glue } = (await import('ammojs-typed/wasm')) as unknown as { default: Glue };
  if (!program) return glue.call({}, {});
  return new Promise((resolve, reject) => {
    const instantiateWasm: GlueOptions['instantiateWasm'] = (imports, done) => {
      WebAssembly.instantiate(program, imports).then(done, reject);
      return {};
    };
    glue.call({}, { instantiateWasm }).then(resolve, reject);
  });
}
