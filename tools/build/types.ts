// npm run write -- types: writes the TypeScript types that come from the field tables; test/tools/generated-types.long.test.ts holds them.
import { writeFileSync } from 'node:fs';
import { format, resolveConfig } from 'prettier';
import { allTypes } from '../../physics-core/all-types.js';
import { coreFieldTypes, elementPropertyTypes } from './field-types.js';

/** The files and what stands in them. */
export async function generatedTypes(): Promise<Record<string, string>> {
  const types = Object.values(allTypes);
  const texts = {
    'physics-core/face/fields.ts': coreFieldTypes(types),
    'elements/properties.ts': elementPropertyTypes(types),
  };
  const written = Object.entries(texts).map(async ([file, text]) => {
    const options = await resolveConfig(file);
    return [file, await format(text, { ...options, filepath: file })] as const;
  });
  return Object.fromEntries(await Promise.all(written));
}

if (process.argv[1] === import.meta.filename)
  for (const [file, text] of Object.entries(await generatedTypes())) writeFileSync(file, text);
