import { playwrightLauncher } from '@web/test-runner-playwright';
import { CHROMIUM_ARGUMENTS, findChromium } from './tools/test/browsers.js';
import { devtoolsCommand } from './tools/test/devtools-command.js';
import { config } from './tools/test/wtr.js';

export default config(
  playwrightLauncher({
    product: 'chromium',
    launchOptions: {
      executablePath: await findChromium(),
      args: CHROMIUM_ARGUMENTS,
    },
  }),
  [devtoolsCommand()],
);
