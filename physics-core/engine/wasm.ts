// Where ammo.wasm is, and how it is read.

/** Where the engine's files are; by default beside this one. */
export interface EngineSource {
  /** Where ammo.wasm is. */
  wasmUrl?: string | URL | undefined;
  /** The wasm itself, or what answers it when it is needed, for pages that may fetch nothing. */
  wasmBinary?: Uint8Array | (() => Uint8Array | Promise<Uint8Array>) | undefined;
  /** Where x3d-physics.classic.js is, which `measureAccuracy` has for a worker. */
  workerUrl?: string | URL | undefined;
}

export interface LoadOptions extends EngineSource {
  /** The wasm compiled: another engine's. */
  program?: WebAssembly.Module | undefined;
}

let configured: EngineSource = {};
/** The wasm is there: from now on every engine is made of it. */
let done = false;

/** Who says where the wasm is says all of it: no earlier word's bytes come before a later one's address. */
function merge(before: EngineSource, { wasmUrl, wasmBinary, workerUrl }: EngineSource) {
  const wasm = wasmUrl || wasmBinary ? { wasmUrl, wasmBinary } : before;
  return {
    wasmUrl: wasm.wasmUrl,
    wasmBinary: wasm.wasmBinary,
    workerUrl: workerUrl ?? before.workerUrl,
  };
}

/**
 * Says where the engine's files are, for pages whose bundler or server has them elsewhere. To be called as soon as
 * the library is there, before the engine is.
 * @example
 * configure({ wasmUrl: '/assets/ammo.wasm' });
 */
export function configure(source: EngineSource): void {
  if (done) throw new Error('configure() comes too late: the physics engine is loaded already');
  configured = merge(configured, source);
}

/** The script that imports us may say where the files are: it runs to its end first. */
const nextTask = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

/**
 * The wasm compiled, which serves any number of engines, and where their worker is. No `program` in Node running from
 * source: the glue finds its own.
 */
export async function compileAmmo(options: LoadOptions): Promise<LoadOptions> {
  if (options.program) return options;
  await nextTask();
  const said = configured;
  const source = merge(said, options);
  const compiling = compiled(source);
  await compiling.catch(() => {});
  // Another script of the page has spoken meanwhile.
  if (said !== configured) return compileAmmo(options);
  const program = await compiling;
  done = true;
  return { program, workerUrl: source.workerUrl };
}

async function compiled({ wasmBinary, wasmUrl }: EngineSource) {
  if (wasmBinary) {
    const bytes = typeof wasmBinary === 'function' ? await wasmBinary() : wasmBinary;
    return WebAssembly.compile(bytes as BufferSource);
  }
  if (wasmUrl) return compiledFrom(String(wasmUrl));
  return ours();
}

const inNode = typeof process === 'object' && !!process.versions?.node;

/**
 * The one beside this file. Bundlers that know of no such file copy none, and servers answer 404 or a page in its
 * place: then the wasm comes as text, in a chunk of its own that nobody else loads.
 */
async function ours(): Promise<WebAssembly.Module | undefined> {
  try {
    return await compiledFrom(new URL('./ammo.wasm', import.meta.url).href);
  } catch (error) {
    const spare = await import('virtual:ammo-wasm').catch(() => undefined);
    if (spare) return WebAssembly.compile((await spare.default()) as BufferSource);
    // Node running from source has neither: the glue finds its own.
    if (inNode) return undefined;
    throw error;
  }
}

/** Read here and not by the glue, which would abort long after, without the address. */
async function compiledFrom(url: string): Promise<WebAssembly.Module> {
  try {
    return await (inNode && !/^(https?|data|blob):/.test(url) ? readFile(url) : fetchWasm(url));
  } catch (error) {
    const why = error instanceof Error ? error.message : String(error);
    const hint = 'configure({ wasmUrl }) says where ammo.wasm is';
    throw new Error(`${url} can't be had (${why}); ${hint}`, { cause: error });
  }
}

/** Without an import, which bundlers for pages could not resolve. */
async function readFile(url: string): Promise<WebAssembly.Module> {
  const files = process.getBuiltinModule('node:fs/promises');
  const bytes = await files.readFile(url.startsWith('file:') ? new URL(url) : url);
  return WebAssembly.compile(bytes as BufferSource);
}

/** Compiled while it comes, where the server names its type: only then browsers allow it. */
async function fetchWasm(url: string): Promise<WebAssembly.Module> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`the server answered ${response.status}`);
  const type = response.headers.get('content-type') ?? '';
  if (/^application\/wasm$/i.test(type.trim())) return WebAssembly.compileStreaming(response);
  const bytes = new Uint8Array(await response.arrayBuffer());
  if (!isWasm(bytes)) throw new Error(`the server answered ${type || 'something'} instead`);
  return WebAssembly.compile(bytes);
}

/** What every WebAssembly file begins with: NUL, "asm". */
const MAGIC = [0x00, 0x61, 0x73, 0x6d];
const isWasm = (bytes: Uint8Array): boolean => MAGIC.every((byte, i) => bytes[i] === byte);
