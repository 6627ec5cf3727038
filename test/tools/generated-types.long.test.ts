import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { generatedTypes } from '../../tools/build/types.js';
import { fact } from '../core/helpers.js';

fact(
  'the types of fields and properties are those of the tables (npm run write -- types)',
  async () => {
    for (const [file, text] of Object.entries(await generatedTypes()))
      assert.equal(readFileSync(file, 'utf8'), text, file);
  },
);
