// An application as people write one: an empty project with the packed package, x3dom and the frameworks' types.
import {
  copyFileSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { npm } from '../../processes.js';

/** Whose templates know our tags. */
const FRAMEWORKS = [
  ...['@types/node@20', '@types/react@19', 'preact@10', 'solid-js@1', 'svelte@5', 'vue@3'],
];

export const SCENE = `<x3d width="300px" height="200px"><scene>
  <transform translation="0 5 0"><shape><box></box></shape><x3d-rigid-body id="ball"></x3d-rigid-body></transform>
</scene></x3d>`;

/** A page that loads x3dom, then `scripts`. */
export const html = (scripts, body = '') => `<!doctype html>
<html lang="en">
  <head><meta charset="utf-8" /><title>An application</title><script src="x3dom.js"></script></head>
  <body>${SCENE}${body}${scripts}</body>
</html>`;

/** A folder for one check, with these files in it: the text of a file, or where it is copied from. */
export function folderOf(root, name, files) {
  const folder = join(root, name);
  for (const [path, { text, from }] of Object.entries(files)) {
    const file = join(folder, path);
    mkdirSync(dirname(file), { recursive: true });
    if (from) copyFileSync(from, file);
    else writeFileSync(file, text);
  }
  return folder;
}

/** Packs the package and installs it, from the registry as an application would. Answers the project's folder. */
export async function install() {
  const folder = mkdtempSync(join(tmpdir(), 'x3d-physics-application-'));
  const packed = await npm(['pack', '--pack-destination', folder], { quiet: true });
  if (!packed.ok) throw new Error(packed.output);
  const tarball = readdirSync(folder).find((name) => name.endsWith('.tgz'));
  const project = { private: true, type: 'module' };
  writeFileSync(join(folder, 'package.json'), JSON.stringify(project));
  const { x3dom } = JSON.parse(readFileSync('package.json', 'utf8')).devDependencies;
  const installed = await npm(
    [
      ...['install', '--prefer-offline', '--ignore-scripts', '--no-audit', '--no-fund'],
      ...[join(folder, tarball), `x3dom@${x3dom}`, ...FRAMEWORKS],
    ],
    { cwd: folder, quiet: true },
  );
  if (!installed.ok) throw new Error(installed.output);
  return folder;
}
