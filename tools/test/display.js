import { spawn } from 'node:child_process';
import { endWithUs } from '../endings.js';

/**
 * Makes sure that there is a display: without a window, Firefox and WebKitGTK have no WebGL. Where DISPLAY
 * is not set, starts Xvfb on the next free number and sets it.
 */
export async function ensureDisplay() {
  if (process.platform !== 'linux' || process.env.DISPLAY) return;
  const xvfb = endWithUs(
    spawn(
      'Xvfb',
      ['-displayfd', '1', '-screen', '0', '1280x1024x24', '-nolisten', 'tcp', '-noreset'],
      { stdio: ['ignore', 'pipe', 'ignore'] },
    ),
  );
  const number = await new Promise((resolve, reject) => {
    xvfb.stdout.once('data', (text) => resolve(String(text).trim()));
    xvfb.once('error', reject);
    xvfb.once('exit', () => reject(new Error('Xvfb ended at once')));
  });
  // Neither may keep us alive when the tests are over.
  xvfb.unref();
  xvfb.stdout.unref();
  process.env.DISPLAY = `:${number}`;
}
