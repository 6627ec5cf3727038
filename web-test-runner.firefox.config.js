import { puppeteerLauncher } from '@web/test-runner-puppeteer';
import { findFirefox } from './tools/test/browsers.js';
import { ensureDisplay } from './tools/test/display.js';
import { config } from './tools/test/wtr.js';

await ensureDisplay();

// Puppeteer, because Playwright drives only a Firefox of its own; in a window, because headless has no WebGL.
export default config(
  puppeteerLauncher({
    launchOptions: { browser: 'firefox', executablePath: findFirefox(), headless: false },
    concurrency: 1,
  }),
);
