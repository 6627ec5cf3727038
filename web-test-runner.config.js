import { playwrightLauncher } from '@web/test-runner-playwright';
import { CHROMIUM_ARGUMENTS, findChromium } from './tools/browsers.js';
import { devtoolsCommand } from './tools/devtools-command.js';
import { config } from './tools/wtr.js';

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
