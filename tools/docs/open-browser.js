// A page in a browser that nobody steers: it is opened at an address, and closed.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { setTimeout as wait } from 'node:timers/promises';
import { CHROMIUM_ARGUMENTS, findChromium, findFirefox, findWebKit } from '../test/browsers.js';
import { ensureDisplay } from '../test/display.js';
import { endWithUs } from '../endings.js';

/** Command, arguments and environment of each, with a profile of its own in `folder`. */
const COMMANDS = {
  chromium: async (address, folder) => ({
    command: await findChromium(),
    args: [...CHROMIUM_ARGUMENTS, '--headless', `--user-data-dir=${folder}`, address],
  }),
  // Without a window it has no WebGL.
  firefox: async (address, folder, { draws }) => {
    if (draws) await ensureDisplay();
    const window = draws ? [] : ['--headless'];
    return {
      command: findFirefox(),
      args: [...window, '--no-remote', '--profile', folder, address],
    };
  },
  webkit: async (address) => {
    await ensureDisplay();
    return {
      command: findWebKit()?.browser,
      args: ['--private', address],
      env: {
        LIBGL_ALWAYS_SOFTWARE: '1',
        // Of no locale it tells pages a language that is none.
        LANG: 'en_US.UTF-8',
        // Its sandbox cannot start as root, which containers and CI are.
        ...(process.getuid?.() === 0 && { WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS: '1' }),
      },
    };
  },
};

export const BROWSERS = Object.keys(COMMANDS);

/** A browser's helpers write into its profile for a moment after it has ended; what they leave then stays. */
async function remove(folder) {
  for (let tries = 0; tries < 10; tries++) {
    try {
      return rmSync(folder, { recursive: true, force: true });
    } catch {
      await wait(200);
    }
  }
}

/** Opens the page, and answers how it is closed. It ends with our process. `draws`: it needs WebGL. */
export async function openBrowser(name, address, { draws = false } = {}) {
  const folder = mkdtempSync(join(tmpdir(), `x3d-physics-${name}-`));
  const { command, args, env } = await COMMANDS[name](address, folder, { draws });
  if (!command) throw new Error(`${name} is not installed`);
  const child = spawn(command, args, { stdio: 'ignore', env: { ...process.env, ...env } });
  const ended = new Promise((resolve) => child.once('exit', resolve).once('error', resolve));
  endWithUs(child);
  return {
    ended,
    async close() {
      child.kill();
      await ended;
      await remove(folder);
    },
  };
}
