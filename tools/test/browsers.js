// Which browsers this machine has, and how a Chromium gets onto it.
import { existsSync, readdirSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import { BIN, run, runNode } from '../processes.js';

function onPath(...names) {
  const folders = (process.env.PATH ?? '').split(delimiter);
  return names.flatMap((name) => folders.map((folder) => join(folder, name))).find(existsSync);
}

/** Folders under /usr/lib (and its per-architecture folders) whose name fits. */
function libraryFolders(pattern) {
  if (!existsSync('/usr/lib')) return [];
  const names = (folder) => readdirSync(folder, { withFileTypes: true }).filter((e) => !e.isFile());
  return names('/usr/lib')
    .filter((entry) => entry.name.includes('linux-gnu') || pattern.test(entry.name))
    .map((entry) => join('/usr/lib', entry.name))
    .flatMap((folder) =>
      pattern.test(folder) ? [folder] : names(folder).map((entry) => join(folder, entry.name)),
    )
    .filter((folder) => pattern.test(folder));
}

/** Playwright's own Chromium, where it was downloaded. */
async function playwrightChromium() {
  const { chromium } = await import('playwright');
  const path = chromium.executablePath();
  return existsSync(path) ? path : undefined;
}

export async function findChromium() {
  return (
    process.env.CHROME_PATH ??
    onPath('chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable', 'chrome') ??
    [
      '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
      '/Applications/Chromium.app/Contents/MacOS/Chromium',
      'C:\\Program Files\\Google\\Chrome\\Application\\chrome.exe',
    ].find(existsSync) ??
    (await playwrightChromium())
  );
}

export const findFirefox = () =>
  process.env.FIREFOX_PATH ??
  onPath('firefox-esr', 'firefox') ??
  ['/Applications/Firefox.app/Contents/MacOS/firefox'].find(existsSync);

/** WebKitGTK: its driver and the small browser that the driver steers. */
export function findWebKit() {
  const driver = onPath('WebKitWebDriver');
  const browser = libraryFolders(/\/webkit2?gtk-[\d.]+$/)
    .map((folder) => join(folder, 'MiniBrowser'))
    .find(existsSync);
  return driver && browser ? { driver, browser } : undefined;
}

/** A display for browsers that draw WebGL only in a window: one that is there, or Xvfb. */
export const canShowWindows = () =>
  process.platform !== 'linux' || !!process.env.DISPLAY || !!onPath('Xvfb');

/** For Chromium as root, and in containers with a small /dev/shm. */
const ANYWHERE = ['--no-sandbox', '--disable-dev-shm-usage'];

/** For pages without WebGL: Chromium draws them by itself in less than through a graphics card that is none. */
export const WITHOUT_WEBGL = [...ANYWHERE, '--disable-gpu'];

/** With WebGL without a graphics card. */
export const CHROMIUM_ARGUMENTS = [
  ...ANYWHERE,
  '--use-gl=angle',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
];

/** Chromium's path. Where there is none: from the distribution, else from Playwright. */
export async function ensureChromium() {
  const found = await findChromium();
  if (found) return found;
  if (process.getuid?.() === 0 && onPath('apt-get')) {
    console.log('Installing Chromium from the distribution (apt-get) …');
    const env = { DEBIAN_FRONTEND: 'noninteractive' };
    await run('apt-get', ['update', '-qq'], { env, quiet: true });
    await run('apt-get', ['install', '-y', '-qq', 'chromium'], { env, quiet: true });
    const installed = onPath('chromium');
    // On Ubuntu the package is a door to the snap store, which containers do not have.
    if (installed && (await run(installed, ['--version'], { quiet: true })).ok) return installed;
  }
  console.log("Downloading Playwright's Chromium …");
  await runNode([BIN.playwright, 'install', 'chromium'], { timeout: 5 * 60_000 });
  const downloaded = await playwrightChromium();
  if (downloaded) return downloaded;
  throw new Error(
    'No browser: install Chromium or Chrome, or set CHROME_PATH to one, and run npm test again.',
  );
}
