// What the guide shows of each framework compiles: beside the sources of its example, by the example's own tools.
import { readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const GUIDE = 'site/guide/frameworks.md';
const SECTION = /^## (.+)\n([^]*?)(?=^## |(?![^]))/gm;
const FENCE = /^```(\w+)\n([^]*?)^```$/gm;

/** By example: the guide's section, and the file that each of its fences becomes. */
const PLACES = {
  react: { section: 'React', files: ['src/guide-snippet.tsx', 'src/guide-list.tsx'] },
  vue: { section: 'Vue', files: ['src/guide-snippet.config.ts', 'src/GuideSnippet.vue'] },
  svelte: { section: 'Svelte', files: ['src/GuideSnippet.svelte'] },
  solid: { section: 'Solid', files: ['src/guide-snippet.tsx'] },
  preact: { section: 'Preact', files: ['src/guide-snippet.tsx'] },
  lit: { section: 'Lit, and others with shadow roots', files: ['src/guide-snippet.ts'] },
  angular: { section: 'Angular', files: ['src/app/guide-snippet.ts'] },
};

const snippetsIn = (text) => [...text.matchAll(FENCE)].map(([, , code]) => code);

/** Of one section; a snippet without a place would be one that nobody compiles. */
function snippetsOf({ section, files }) {
  const sections = [...readFileSync(GUIDE, 'utf8').matchAll(SECTION)];
  const known = Object.values(PLACES).map((place) => place.section);
  const homeless = sections.filter(
    ([, name, text]) => !known.includes(name) && snippetsIn(text).length > 0,
  );
  const [, , text] = sections.find(([, name]) => name === section) ?? [];
  const snippets = snippetsIn(text ?? '');
  if (homeless.length > 0 || snippets.length !== files.length)
    throw new Error(
      `tools/test/examples/guide.js has no place for a snippet of ${GUIDE}: ${section}`,
    );
  return snippets;
}

/** Has the snippets of the guide beside the example's own files while `check` runs. */
export async function withSnippets(example, folder, check) {
  const place = PLACES[example];
  if (!place) return check();
  const files = place.files.map((file) => join(folder, file));
  try {
    snippetsOf(place).forEach((code, i) => writeFileSync(files[i], code));
    await check();
  } finally {
    for (const file of files) rmSync(file, { force: true });
  }
}
