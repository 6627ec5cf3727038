// The package in pages: its builds as they are.
/* global customElements, document */
import assert from 'node:assert/strict';
import { cpSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { serve } from '../../docs/static-files.js';
import { folderOf, html } from './application.js';

export const PORT = 8400;
const DIST = 'node_modules/x3d-physics/dist';
/** Milliseconds that a page on a busy machine may take. */
const PATIENCE = 60_000;

export const MAIN = "import { worldOf } from 'x3d-physics';\nglobalThis.worldOf = worldOf;\n";
export const MODULE = '<script type="module" src="main.js"></script>';
const IMPORT_MAP = JSON.stringify({
  imports: { 'x3d-physics': './x3d-physics/x3d-physics.js', 'x3d-physics/': './x3d-physics/' },
});

/** Runs in a page: how far a ball has fallen after a second, in a world that the page finds by itself. */
async function fallen() {
  await customElements.whenDefined('x3d-rigid-body');
  const ball = document.querySelector('#ball');
  const world = await ball.world.ready;
  world.paused = true;
  world.reset();
  world.advance(1);
  return ball.position[1] - 5;
}

/** Runs in a page: whether a measurement runs in a worker, and not between frames. */
async function measured() {
  const { world } = document.querySelector('#ball');
  const rows = await world.measureAccuracy({ seconds: 0.1, levels: ['game', 'standard'] });
  return rows.map(({ inWorker }) => inWorker);
}

export const measures = (inWorker) => async (page) =>
  assert.deepEqual(await page.evaluate(measured), [inWorker, inWorker], 'it measures in a worker');

/** Opens a page in which the ball must fall. Answers what it loaded. */
export async function falls(browser, address, more = async () => {}) {
  const page = await browser.newPage();
  page.setDefaultTimeout(PATIENCE);
  const loaded = [];
  const errors = [];
  page.on('response', (response) => loaded.push(`${response.status()} ${response.url()}`));
  page.on('pageerror', (error) => errors.push(error.message));
  try {
    await page.goto(address);
    const height = await page.evaluate(fallen);
    assert.ok(Math.abs(height + 4.9) < 0.05, `the ball fell by ${height} m`);
    await more(page);
    assert.deepEqual(errors, []);
  } catch (error) {
    throw new Error([error.message, ...errors, ...loaded].join('\n    '), { cause: error });
  } finally {
    await page.close();
  }
  return loaded;
}

export const came = (loaded, file) =>
  loaded.some((line) => line.startsWith('200') && line.includes(file));

/** Serves a folder as it is: what is not there is a 404. */
export async function served(browser, folder, more) {
  const { port, close } = await serve(folder, PORT);
  try {
    return await falls(browser, `http://localhost:${port}/`, more);
  } finally {
    await close();
  }
}

/** A folder with a page, x3dom and these files. */
export const site = (application, name, page, files = {}) =>
  folderOf(application, name, {
    'index.html': { text: page },
    'x3dom.js': { from: join(application, 'node_modules/x3dom/x3dom.js') },
    ...files,
  });

/** Copies files and folders of the package's dist/ into a folder. */
function copy(application, folder, ...names) {
  for (const name of names)
    cpSync(join(application, DIST, name), join(folder, name), { recursive: true });
}

/** The monitor and the chart show something, once they are in sight. What grows above may push them out of it again. */
async function showsViews(page) {
  for (const tag of ['x3d-physics-monitor', 'x3d-accuracy-chart']) {
    const button = page.locator(`${tag} button`).first();
    for (const until = Date.now() + PATIENCE; !(await button.isVisible());) {
      assert.ok(Date.now() < until, `<${tag}> shows nothing`);
      await page.locator(tag).evaluate((element) => element.scrollIntoView());
      await page.waitForTimeout(100);
    }
  }
}

async function showsAndMeasures(page) {
  await showsViews(page);
  await measures(true)(page);
}

const VIEWS =
  '<x3d-physics-monitor></x3d-physics-monitor><x3d-accuracy-chart></x3d-accuracy-chart>';

/** All of dist/ by an import map; the wasm is found, and its spare stays where it is. */
export async function moduleBuild(application, browser) {
  const head = `<script type="importmap">${IMPORT_MAP}</script>`;
  const folder = site(application, 'module', html(head + MODULE, VIEWS), {
    'main.js': { text: MAIN },
  });
  copy(application, join(folder, 'x3d-physics'), '.');
  const loaded = await served(browser, folder, showsAndMeasures);
  assert.ok(came(loaded, 'ammo.wasm'), 'ammo.wasm is loaded');
  assert.ok(!came(loaded, 'wasm-as-text'), 'its spare is not');
}

/** As from a server of packages: page and package have different origins. */
export async function otherOrigin(application, browser) {
  const { port, close } = await serve(join(application, DIST), PORT + 50);
  const imports = { 'x3d-physics': `http://localhost:${port}/x3d-physics.js` };
  const head = `<script type="importmap">${JSON.stringify({ imports })}</script>`;
  const folder = site(application, 'origin', html(head + MODULE, VIEWS), {
    'main.js': { text: MAIN },
  });
  try {
    const loaded = await served(browser, folder, showsAndMeasures);
    assert.ok(came(loaded, `${port}/ammo.wasm`) && came(loaded, `${port}/ui/monitor.js`));
    assert.ok(!came(loaded, 'wasm-as-text'), 'ammo.wasm is found');
  } finally {
    await close();
  }
}

/** Only the elements that a page imports. */
export async function singleElements(application, browser) {
  const folder = site(
    application,
    'elements',
    html(`<script type="importmap">${IMPORT_MAP}</script>${MODULE}`),
    {
      'main.js': {
        text: `import { X3DRigidBodyElement } from 'x3d-physics/elements/x3d-rigid-body.js';
          customElements.define('x3d-rigid-body', X3DRigidBodyElement);`,
      },
    },
  );
  copy(application, join(folder, 'x3d-physics'), '.');
  await served(browser, folder);
}

/** With what the guide says must lie beside it, and nothing else. */
export async function classicScript(application, browser) {
  const page = html('', VIEWS).replace(
    '</head>',
    '<script src="x3d-physics.classic.js"></script>$&',
  );
  const folder = site(application, 'classic', page);
  copy(application, folder, 'x3d-physics.classic.js', 'ammo.wasm', 'ui');
  const loaded = await served(browser, folder, showsAndMeasures);
  assert.ok(came(loaded, 'ui/monitor.js') && came(loaded, 'ui/chart.js'));
}

/** Opened from disk, with nothing beside it. */
export async function singleScript(application, browser) {
  const page = html('').replace('</head>', '<script src="x3d-physics.single.js"></script>$&');
  const folder = site(application, 'single', page);
  copy(application, folder, 'x3d-physics.single.js');
  await falls(browser, pathToFileURL(join(folder, 'index.html')).href, measures(false));
}
