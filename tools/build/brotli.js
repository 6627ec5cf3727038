// What is built, packed by Brotli beside it: `ammo.wasm.br` for servers that answer with such files and pack nothing themselves.
import { Buffer } from 'node:buffer';
import { writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { promisify } from 'node:util';
import { brotliCompress, constants } from 'node:zlib';

/** What is shorter fills no packet either way. */
const SHORTEST = 1000;

/** Which files: pages opened from disk have no server, and the wasm as text is packed already. */
const isServed = (name) => /\.(js|wasm)$/.test(name) && !/\.single\.|as-text/.test(name);

const pack = promisify(brotliCompress);

/** As small as it gets: it is done once. */
const packed = (bytes) =>
  pack(bytes, {
    params: {
      [constants.BROTLI_PARAM_QUALITY]: constants.BROTLI_MAX_QUALITY,
      [constants.BROTLI_PARAM_SIZE_HINT]: bytes.length,
    },
  });

/** For Rollup. */
export function brotli() {
  return {
    name: 'brotli',
    async writeBundle({ dir, file }, bundle) {
      const write = async ({ fileName, code, source }) => {
        const bytes = Buffer.from(code ?? source);
        if (!isServed(fileName) || bytes.length < SHORTEST) return;
        await writeFile(join(dir ?? dirname(file), `${fileName}.br`), await packed(bytes));
      };
      await Promise.all(Object.values(bundle).map(write));
    },
  };
}
