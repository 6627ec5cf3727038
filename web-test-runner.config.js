import { playwrightLauncher } from '@web/test-runner-playwright';
import { findChromium } from './tools/browsers.js';
import { devtoolsCommand } from './tools/devtools-command.js';
import { config } from './tools/wtr.js';

export default config(
  playwrightLauncher({
    product: 'chromium',
    launchOptions: {
      executablePath: await findChromium(),
      args: [
        // As root, and in containers with a small /dev/shm.
        '--no-sandbox',
        '--disable-dev-shm-usage',
        // WebGL without a graphics card.
        '--use-gl=angle',
        '--use-angle=swiftshader',
        '--enable-unsafe-swiftshader',
      ],
    },
  }),
  [devtoolsCommand()],
);
