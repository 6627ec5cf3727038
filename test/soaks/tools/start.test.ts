import assert from 'node:assert/strict';
import { spawn, type ChildProcess } from 'node:child_process';
import { existsSync } from 'node:fs';
import { test } from 'node:test';

/** Milliseconds that a server may take to be gone. */
const SOON = 5000;

/** Runs `npm start` in a process group of its own until it says where the documentation is; what it says later is heard. */
function started(): Promise<{ npm: ChildProcess; address: string }> {
  const npm = spawn('npm', ['start'], { detached: true, stdio: ['ignore', 'pipe', 'inherit'] });
  let said = '';
  return new Promise((resolve, reject) => {
    npm.once('exit', () => reject(new Error(said)));
    npm.stdout!.on('data', (text) => {
      said += text;
      const address = /documentation is at (http\S+)/.exec(said)?.[1];
      if (address) resolve({ npm, address });
    });
  });
}

const answers = (address: string): Promise<boolean> =>
  // No connection is kept from the server before.
  fetch(address, { headers: { connection: 'close' } }).then(
    ({ ok }) => ok,
    () => false,
  );

async function isGone(address: string): Promise<boolean> {
  for (const end = Date.now() + SOON; Date.now() < end;)
    if (!(await answers(address))) return true;
    else await new Promise((resolve) => setTimeout(resolve, 100));
  return false;
}

const ENDS: Record<string, (npm: ChildProcess) => unknown> = {
  'Ctrl+C': ({ pid }) => process.kill(-pid!, 'SIGINT'),
  'a terminal that closes': ({ pid }) => process.kill(-pid!, 'SIGHUP'),
  'SIGTERM to npm alone': (npm) => npm.kill('SIGTERM'),
  'SIGKILL to npm alone': (npm) => npm.kill('SIGKILL'),
};

for (const [by, end] of Object.entries(ENDS))
  test(`npm start, ended by ${by}, leaves nothing on its port, and dist/ whole`, async () => {
    const { npm, address } = await started();
    assert.ok(await answers(address));
    end(npm);
    assert.ok(await isGone(address), `${address} still answers`);
    // It was building the stories, and what they show.
    assert.ok(existsSync('dist/x3d-physics.js'));
  });
