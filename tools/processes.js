import { spawn } from 'node:child_process';
import { constants, setPriority } from 'node:os';
import { endWithUs } from './endings.js';
import { started } from './processor-time.js';

/**
 * Runs a command to its end. `quiet` keeps what it says for the answer instead of showing it; `'stdout'` keeps that alone.
 * `calm`: whatever else runs goes before it. A command that takes longer than `timeout` is stopped and counts as failed; it
 * ends with us, too.
 */
export function run(
  command,
  args,
  { env, cwd, quiet = false, calm = false, timeout = 20 * 60_000 } = {},
) {
  return new Promise((resolve) => {
    const child = spawn(command, args, {
      stdio: ['ignore', quiet ? 'pipe' : 'inherit', quiet === true ? 'pipe' : 'inherit'],
      env: { ...process.env, ...env },
      cwd,
    });
    started(child.pid);
    endWithUs(child);
    if (calm && child.pid) setPriority(child.pid, constants.priority.PRIORITY_LOW);
    let output = '';
    child.stdout?.on('data', (text) => (output += text));
    child.stderr?.on('data', (text) => (output += text));
    const timer = setTimeout(() => {
      console.error(`${command} ${args[0]} took longer than ${timeout / 1000} s and is stopped`);
      child.kill();
    }, timeout);
    const end = (ok) => {
      clearTimeout(timer);
      resolve({ ok, output });
    };
    child.on('error', (error) => {
      output += error.message;
      end(false);
    });
    child.on('close', (code) => end(code === 0));
  });
}

/** npm itself: on Windows a script of the command line's. */
export const npm = (args, options) =>
  process.platform === 'win32'
    ? run('cmd', ['/c', 'npm', ...args], options)
    : run('npm', args, options);

/** Runs a script with the Node that runs us: needs neither the executable bit nor a shell. */
export const runNode = (args, options) => run(process.execPath, args, options);

/** Where the commands of our packages are. `.bin` is avoided: npm sometimes loses its executable bits. */
export const BIN = {
  attw: 'node_modules/@arethetypeswrong/cli/dist/index.js',
  eslint: 'node_modules/eslint/bin/eslint.js',
  playwright: 'node_modules/playwright/cli.js',
  prettier: 'node_modules/prettier/bin/prettier.cjs',
  rollup: 'node_modules/rollup/dist/bin/rollup',
  storybook: 'node_modules/storybook/dist/bin/dispatcher.js',
  /** What our users compile with, and what typescript-eslint and Rollup read types by. */
  tsc: 'node_modules/typescript/bin/tsc',
  /** The same compiler in machine code, without that interface: a tenth of the time. */
  tsc7: 'node_modules/typescript-7/bin/tsc',
  vitepress: 'node_modules/vitepress/bin/vitepress.js',
  wtr: 'node_modules/@web/test-runner/dist/bin.js',
};
