// types/ of what is built: a declaration file for each entry of the package, with what it shows and nothing else.
import { rollup } from 'rollup';
import { dts } from 'rollup-plugin-dts';
import { globSync } from '../files.js';

/** What tsc makes of every source file, see tsconfig.types.json; it is gone after the build. */
export const declarationsIn = (folder) => `${folder}/declarations`;

const elementsIn = (declarations) =>
  globSync(`${declarations}/elements/x3d-*.d.ts`).map((file) => [
    file.replace(`${declarations}/`, '').replace('.d.ts', ''),
    file,
  ]);

export async function bundleDeclarations(folder) {
  const declarations = declarationsIn(folder);
  const bundle = await rollup({
    input: {
      index: `${declarations}/elements/index.d.ts`,
      core: `${declarations}/physics-core/index.d.ts`,
      ...Object.fromEntries(elementsIn(declarations)),
    },
    // What only the inside names goes with it: nothing that is shown names Bullet's own types.
    external: ['ammojs-typed/wasm'],
    treeshake: { moduleSideEffects: 'no-external' },
    plugins: [dts()],
    onLog(level, log, handle) {
      if (!PRIVATE.test(log.message)) handle(level, log);
    },
  });
  await bundle.write({
    dir: `${folder}/types`,
    format: 'es',
    entryFileNames: '[name].d.ts',
    chunkFileNames: 'shared-[hash].d.ts',
  });
  await bundle.close();
}

/** Types that are shown only as parts of others need no names of their own. */
const PRIVATE = /private shared type exports/;
