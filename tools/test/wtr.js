// What the three configurations of Web Test Runner share.
import { defaultReporter } from '@web/test-runner';
import { sourceOf, wasmOfTests } from './bundle-tests.js';
import { countReporter } from './count-reporter.js';
import { freePort } from '../docs/ports.js';
import { CONTENT } from './stages.js';
import { findFile } from '../docs/static-files.js';
import { touchPlugin } from './touch.js';

/** Where a URL's file is taken as it is, unseen by the plugins that rewrite modules and pages. */
function rawFile(path) {
  if (path.startsWith('/content/')) {
    return findFile(CONTENT, path.slice('/content'.length));
  }
  if (/^\/(dist|node_modules\/x3dom|x3dom-full)\//.test(path)) {
    return findFile('.', path);
  }
  if (/\.(html|xhtml|x3d|wasm)$/.test(path)) return findFile('.', path);
}

async function rawFiles(context, next) {
  const found = rawFile(context.path);
  // The code says `new URL('./ammo.wasm', import.meta.url)`: beside a bundle of tests there is none.
  if (!found && context.path.endsWith('/ammo.wasm')) {
    context.type = 'application/wasm';
    context.body = wasmOfTests();
    return;
  }
  if (!found) return next();
  const { createReadStream } = await import('node:fs');
  context.set('cache-control', 'no-cache');
  context.type = found.type;
  context.body = createReadStream(found.file);
}

/** x3dom as a page has it, before the test; our library is bundled with the tests themselves. */
const page = (testFramework) => `<!DOCTYPE html>
<html>
  <head>
    <meta charset="utf-8">
    <link rel="stylesheet" href="/node_modules/x3dom/x3dom.css">
    <script src="/node_modules/x3dom/x3dom.js"></script>
    <script type="module" src="${testFramework}"></script>
  </head>
  <body></body>
</html>`;

/** Of its own: two runners that begin together would take the same one. */
const port = await freePort();

/** `plugins`: what only this browser can do. */
export function config(browser, plugins = []) {
  return {
    rootDir: process.cwd(),
    port,
    // tools/test/test.js bundles them and says which.
    files: 'test-bundles/*/**/*.test.js',
    browsers: [browser],
    // One page at a time: WebGL in software takes both cores, and a second page would halve the frame rate.
    concurrency: 1,
    concurrentBrowsers: 1,
    // Bundled already, by tools/test/bundle-tests.js.
    nodeResolve: false,
    plugins: [...plugins, touchPlugin()],
    middleware: [rawFiles],
    testRunnerHtml: page,
    testFramework: { config: { ui: 'bdd', timeout: 60_000, retries: 0 } },
    browserStartTimeout: 120_000,
    testsStartTimeout: 120_000,
    testsFinishTimeout: 10 * 60_000,
    reporters: [
      defaultReporter({ reportTestProgress: false }),
      countReporter(process.env.TEST_COUNTS, sourceOf),
    ],
  };
}
