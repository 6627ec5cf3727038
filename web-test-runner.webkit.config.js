import { webdriverLauncher } from '@web/test-runner-webdriver';
import { findWebKit } from './tools/test/browsers.js';
import { ensureDisplay } from './tools/test/display.js';
import { startWebKitDriver } from './tools/test/webkit.js';
import { config } from './tools/test/wtr.js';

const { driver, browser } = findWebKit();
await ensureDisplay();

export default config(
  webdriverLauncher({
    automationProtocol: 'webdriver',
    logLevel: 'error',
    hostname: '127.0.0.1',
    port: await startWebKitDriver(driver),
    path: '/',
    capabilities: {
      browserName: 'MiniBrowser',
      'wdio:enforceWebDriverClassic': true,
      'webkitgtk:browserOptions': { binary: browser, args: ['--automation'] },
    },
  }),
);
