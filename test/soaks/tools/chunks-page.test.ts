import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { builtFiles, PAGE } from '../../../tools/docs/effects/chunks.js';

/** Of a size that may differ from the page's before that is to be written anew: a kilobyte, and 3 %. */
const ROUNDING = { bytes: 1000, share: 0.03 };

const LIBRARY = 'dist/x3d-physics.js';
const skip = !existsSync(LIBRARY) && `${LIBRARY} is not built`;

test(
  'docs/chunks.md has the files as they are built: npm run write -- chunks writes it',
  { skip },
  () => {
    const rows = readFileSync(PAGE, 'utf8').matchAll(
      /^\| (\S+) \| ([\d.]+) \| ([\d.]+) \| (.*) \|$/gm,
    );
    const written = new Map(
      [...rows].map(([, name, bytes, brotli, causes]) => [name, { bytes, brotli, causes }]),
    );
    const built = builtFiles();
    assert.deepEqual(
      [...written.keys()],
      built.map(({ name }) => name),
    );
    for (const { name, causes, ...sizes } of built) {
      const row = written.get(name)!;
      assert.equal(row.causes, causes);
      for (const way of ['bytes', 'brotli'] as const) {
        const bytes = sizes[way];
        const difference = Math.abs(Number(row[way]) * 1000 - bytes);
        assert.ok(difference < ROUNDING.bytes + ROUNDING.share * bytes, `${name}: ${bytes} bytes`);
      }
    }
  },
);
