// What the site shows of the rest of the repository: the library and x3dom as pages load them, the pages of docs/ with
// their pictures. Written into folders that are in no commit. The library's folder is the argument, dist/ by default.
import { cpSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { examples } from './examples.js';
import { forSite } from './links.js';
import { llmsTexts } from './llms.js';
import { referencePages } from './reference.js';
import { copyThumbnails, MENU } from './thumbnails.js';

const [library = 'dist'] = process.argv.slice(2);

const GENERATED = 'site/generated';
const PUBLIC = 'site/public';

function write(file: string, text: string): void {
  mkdirSync(dirname(`${GENERATED}/${file}`), { recursive: true });
  writeFileSync(`${GENERATED}/${file}`, text);
}

/** As a package brings them, without what only debuggers and compilers read. */
function copyScripts(): void {
  const filter = (file: string) => !file.endsWith('.map') && !file.endsWith('/types');
  cpSync(library, `${PUBLIC}/x3d-physics`, { recursive: true, filter });
  for (const name of ['x3dom.js', 'x3dom.css'])
    cpSync(`node_modules/x3dom/${name}`, `${PUBLIC}/x3dom/${name}`);
  cpSync('docs/pictures', `${PUBLIC}/pictures`, { recursive: true });
  // What scenes of the playground bring in by <Inline>.
  cpSync('stories/assets/motor.x3d', `${PUBLIC}/scenes/motor.x3d`);
  cpSync('site/markdown/frame.css', `${PUBLIC}/frame.css`);
  cpSync('site/kit/shadows.js', `${PUBLIC}/kit/shadows.js`);
  cpSync('site/kit/logo.svg', `${PUBLIC}/logo.svg`);
}

/** A chart takes the room of the outline beside it. */
const roomFor = (text: string): string =>
  text.includes('.svg)') ? `---\naside: false\n---\n\n${text}` : text;

function copyPages(): void {
  for (const name of readdirSync('docs').filter((file) => file.endsWith('.md')))
    write(`docs/${name}`, roomFor(forSite(readFileSync(`docs/${name}`, 'utf8'))));
  write('changelog.md', forSite(readFileSync('CHANGELOG.md', 'utf8')));
  for (const [name, text] of referencePages()) write(`reference/${name}.md`, text);
}

/** To be copied: its two scripts lie beside it. */
function copyFirstPage(): void {
  const page = readFileSync('examples/falling-box.html', 'utf8');
  write('falling-box.html', page.replaceAll(/"[^"]*\/([\w.-]+\.js)"/g, '"$1"'));
}

for (const folder of [GENERATED, PUBLIC]) rmSync(folder, { recursive: true, force: true });
copyScripts();
copyPages();
copyFirstPage();

/** When all pages are there. */
function writeTexts(): void {
  const { short, full } = llmsTexts(referencePages().map(([name]) => name));
  writeFileSync(`${PUBLIC}/llms.txt`, short);
  writeFileSync(`${PUBLIC}/llms-full.txt`, full);
}
writeTexts();
writeFileSync(`${PUBLIC}/${MENU}`, JSON.stringify(await examples()));
copyThumbnails();
