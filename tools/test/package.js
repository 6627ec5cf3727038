// The packed package, installed into an empty project, works by each of its entries. dist/ must be built.
import { rmSync } from 'node:fs';
import { chromium } from 'playwright';
import { CHROMIUM_ARGUMENTS, ensureChromium } from './browsers.js';
import { install } from './package/application.js';
import * as bundlers from './package/bundlers.js';
import * as editors from './package/editors.js';
import * as entries from './package/entries.js';
import * as pages from './package/pages.js';
import * as tarball from './package/tarball.js';

/** Vite as it is installed here, and whether its server has no way to ammo.wasm. */
const VITES = [
  ['vite-5', true],
  ['vite-6', true],
  ['vite', true],
  ['vite-8', false],
];

/** Each is called with the application's folder and a browser, and throws where the package falls short. */
const CHECKS = [
  ['it is no larger than it must be', tarball.smallEnough],
  ['what is packed beside a file is that file', tarball.packedFilesAreWhole],
  ['nothing in it is superfluous', tarball.nothingSuperfluous],
  ['it names the licences of what is bundled', tarball.namesLicences],
  ['each build begins with name, version and licence', tarball.saysWhatItIs],
  ["the README's links lead to what is there", tarball.linksLead],
  ['publint finds nothing', tarball.publintIsContent],
  ['are the types wrong? no', tarball.typesAreRight],
  ['the manifest of elements is valid by its schema', editors.manifestIsValid],
  ['the manifest has methods, states, events and definitions', editors.manifestIsWhole],
  ['VS Code and JetBrains know each tag', editors.editorsKnowAll],
  ['each export is a file of the package', entries.everyExportIsThere],
  ["no file imports a module of Node's", entries.noModuleOfNode],
  ['each module can be imported in Node', entries.everyModuleRunsInNode],
  ['the core runs in Node', entries.coreRuns],
  ['the core runs in a thread of Node', entries.coreRunsInThread],
  ['the core runs in Node as a bundle without ammo.wasm', entries.coreRunsBundled],
  ['types: programs, React, Preact, Solid, Svelte, Vue', entries.everyTypeCompiles],
  ['types: the core in Node', entries.coreTypesStandAlone],
  ['types: one element by itself', entries.oneElementCompiles],
  ['module build, by an import map, with its ui', pages.moduleBuild],
  ['module build from another origin, by an import map, with its ui', pages.otherOrigin],
  ['elements by themselves', pages.singleElements],
  ['classic script with ammo.wasm and ui/ alone, with its ui', pages.classicScript],
  ['single script from disk, alone', pages.singleScript],
  // Older servers answer with the page where they have no file.
  ...VITES.flatMap(([name, spare]) => [
    [`${name}: its server`, bundlers.viteServer(name, spare)],
    [`${name}: its build`, bundlers.viteBuild(name)],
    [`${name}: a web worker with the core`, bundlers.viteWorker(name)],
  ]),
  ['webpack', bundlers.webpackBuild],
  ['Rollup', bundlers.rollupModules],
  ['esbuild, one script', bundlers.esbuildScript],
  ['esbuild, modules', bundlers.esbuildModules],
];

async function main() {
  const executablePath = await ensureChromium();
  console.log('Packing and installing …');
  const application = await install();
  const browser = await chromium.launch({ executablePath, args: CHROMIUM_ARGUMENTS });
  let failed = 0;
  for (const [name, check] of CHECKS) {
    try {
      await check(application, browser);
      console.log(`✓ ${name}`);
    } catch (error) {
      failed++;
      console.log(`✗ ${name}\n    ${error.message}`);
    }
  }
  await browser.close();
  rmSync(application, { recursive: true, force: true });
  console.log(`${CHECKS.length - failed} passed, ${failed} failed`);
  process.exit(failed === 0 ? 0 : 1);
}

main().catch((error) => {
  console.error(error.message);
  console.log('0 passed, 1 failed');
  process.exit(1);
});
