import { spawn } from 'node:child_process';
import { connect } from 'node:net';
import { setTimeout as wait } from 'node:timers/promises';
import { endWithUs } from '../endings.js';
import { freePort } from '../docs/ports.js';

const listens = (port) =>
  new Promise((resolve) => {
    const socket = connect(port, '127.0.0.1');
    socket.once('connect', () => resolve(true)).once('error', () => resolve(false));
    socket.unref();
    socket.once('connect', () => socket.end());
  });

/** Starts WebKitWebDriver on a free port, which is returned. It ends with our process. */
export async function startWebKitDriver(path) {
  const port = await freePort();
  const driver = endWithUs(
    spawn(path, ['--host=127.0.0.1', `--port=${port}`], {
      stdio: 'ignore',
      env: {
        ...process.env,
        LIBGL_ALWAYS_SOFTWARE: '1',
        // Its sandbox cannot start as root, which containers and CI are.
        ...(process.getuid?.() === 0 && { WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS: '1' }),
      },
    }),
  );
  driver.unref();
  for (let tries = 0; tries < 100; tries++) {
    if (await listens(port)) return port;
    await wait(100);
  }
  throw new Error(`${path} does not answer`);
}
