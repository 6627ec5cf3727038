// npm run write -- manifest: dist/custom-elements.json, editor data and the types for frameworks, from the field tables and from
// what the classes say of themselves. Into dist/, or the folder that is named.
import { existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { uiClasses } from '../../elements/define.js';
import { vscodeData, webTypes } from './editor-data.js';
import { frameworkTypes } from './framework-types.js';
import { manifest, types } from './manifest-elements.js';

const [folder = 'dist'] = process.argv.slice(2);

const write = (file: string, data: unknown): void =>
  writeFileSync(`${folder}/${file}`, JSON.stringify(data));

mkdirSync(folder, { recursive: true });
write('custom-elements.json', manifest());
write('vscode.html-custom-data.json', vscodeData());
write('web-types.json', webTypes());
if (existsSync(`${folder}/types`)) {
  for (const [name, text] of Object.entries(frameworkTypes([...types], uiClasses))) {
    writeFileSync(`${folder}/types/${name}.d.ts`, text);
    // Programs import them by name, and what they import must be there when they run.
    writeFileSync(`${folder}/types/${name}.js`, 'export {};\n');
  }
}
console.log(`${types.length + uiClasses.length} elements in ${folder}/custom-elements.json`);
