import type AmmoModule from 'ammojs-typed/wasm';

/** The loaded Ammo module: Bullet 2.82 as WebAssembly, single precision. */
export type Ammo = typeof AmmoModule;
export type AmmoNamespace = Ammo;

interface GlueOptions {
  instantiateWasm?: (
    imports: WebAssembly.Imports,
    done: (instance: WebAssembly.Instance) => void,
  ) => object;
}

type Glue = (this: object, options: GlueOptions) => Promise<Ammo>;

export async function fetchGlue(): Promise<Glue> {
  const { default: glue } = (await import('ammojs-typed/wasm')) as unknown as { default: Glue };
  return glue;
}

const VIEWS = ['HEAP32', 'HEAPF32', 'HEAPU8'] as const;

/**
 * The glue's object has so many properties that a view of the heap is looked up in it as in a dictionary (measured: 17 ns, here
 * 2), and so is what is called for each point. Views are asked for at every read, since the glue makes new ones when the
 * heap grows: it hands them on.
 */
function withViews(glue: Ammo): Ammo {
  const { getPointer, wrapPointer } = glue;
  const ammo = Object.assign(Object.create(glue) as Ammo, { getPointer, wrapPointer });
  const views = ammo as Record<(typeof VIEWS)[number], unknown>;
  for (const name of VIEWS) {
    views[name] = glue[name];
    Object.defineProperty(glue, name, {
      get: () => views[name],
      set: (view: unknown) => (views[name] = view),
    });
  }
  return ammo;
}

/** A fresh Ammo module, with a heap of its own. The glue ends in `this.Ammo = …` and so needs a receiver. */
export async function loadAmmo(glue: Glue, program: WebAssembly.Module | undefined): Promise<Ammo> {
  if (!program) return withViews(await glue.call({}, {}));
  const ammo = await new Promise<Ammo>((resolve, reject) => {
    const instantiateWasm: GlueOptions['instantiateWasm'] = (imports, done) => {
      WebAssembly.instantiate(program, imports).then(done, reject);
      return {};
    };
    glue.call({}, { instantiateWasm }).then(resolve, reject);
  });
  return withViews(ammo);
}
