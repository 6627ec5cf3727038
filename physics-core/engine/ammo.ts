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

/** A fresh Ammo module, with a heap of its own. The glue ends in `this.Ammo = …` and so needs a receiver. */
export async function loadAmmo(glue: Glue, program: WebAssembly.Module | undefined): Promise<Ammo> {
  if (!program) return glue.call({}, {});
  return new Promise((resolve, reject) => {
    const instantiateWasm: GlueOptions['instantiateWasm'] = (imports, done) => {
      WebAssembly.instantiate(program, imports).then(done, reject);
      return {};
    };
    glue.call({}, { instantiateWasm }).then(resolve, reject);
  });
}
