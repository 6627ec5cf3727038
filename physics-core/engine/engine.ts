import { compileAmmo, loadAmmo, type Ammo, type LoadOptions } from './ammo.js';
import { ContactHook } from './contact-hook.js';
import { bodyOffsetsHold } from './heap-check.js';
import { ApiReader, HeapReader, type BodyReader } from './heap.js';
import { Scratch } from './scratch.js';

/** Ammo and what all worlds share of it: argument objects and the way state is read. */
export class Engine {
  readonly ammo: Ammo;
  /** What it was made of, for others like it; undefined in Node running from source. */
  readonly program: WebAssembly.Module | undefined;
  readonly scratch: Scratch;
  readonly reader: BodyReader;
  readonly contacts: ContactHook;
  /** False with another Ammo build: then nothing is written to the heap and reads go through the API. */
  readonly heapTrusted: boolean;

  constructor(ammo: Ammo, program?: WebAssembly.Module) {
    this.ammo = ammo;
    this.program = program;
    this.scratch = new Scratch(ammo);
    this.contacts = new ContactHook(ammo);
    this.heapTrusted = bodyOffsetsHold(ammo);
    this.reader = this.heapTrusted ? new HeapReader(ammo) : new ApiReader();
  }

  /** Bytes of the wasm heap, shared by all worlds of the page. It never shrinks. */
  get heapBytes(): number {
    return this.ammo.HEAPU8.length;
  }
}

/** One more, with a heap of its own that goes with it. */
export const newEngine = async (program: WebAssembly.Module | undefined): Promise<Engine> =>
  new Engine(await loadAmmo(program), program);

let loading: Promise<Engine> | undefined;

/** One engine per page, worker or process. A failed load may be tried again. */
export function loadEngine(options: LoadOptions = {}): Promise<Engine> {
  loading ??= compileAmmo(options).then(newEngine);
  loading.catch(() => (loading = undefined));
  return loading;
}
