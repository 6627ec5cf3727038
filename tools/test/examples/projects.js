// How each example is installed, built and served.
import { spawn } from 'node:child_process';
import { join } from 'node:path';
import { npm } from '../../processes.js';
import { ROUTES } from './facts.js';
import { withSnippets } from './guide.js';
import { hotFacts } from './hot.js';
import { SERVED } from './served.js';
import { STARTER } from './starter.js';
import { serve } from '../../docs/static-files.js';

const PORT = 8500;
/** Vite's preview, which serves files here, says production to all that comes after it. */
const ENV = { NODE_ENV: undefined, NO_COLOR: '1', NEXT_TELEMETRY_DISABLED: '1' };

const folderOf = (example) => join('examples', example);

async function must(args, cwd) {
  const { ok, output } = await npm(args, { cwd, env: ENV, quiet: true });
  if (!ok) throw new Error(`npm ${args.join(' ')}\n${output}`);
}

/** As its README says, and with the package as it is packed: see .npmrc there. */
export async function install(example) {
  const cwd = folderOf(example);
  await must(['ci', '--prefer-offline', '--ignore-scripts', '--no-audit', '--no-fund'], cwd);
  await withSnippets(example, cwd, () => must(['run', '--if-present', 'check'], cwd));
  await must(['run', '--if-present', 'build'], cwd);
}

/** The files of a folder as they are. */
const files =
  (...folder) =>
  async () => {
    const { port, close } = await serve(join('examples', ...folder), PORT);
    return { address: `http://localhost:${port}/`, close };
  };

/** A server that says its address when it is ready, as those of frameworks do. */
const server =
  (example, ...args) =>
  () =>
    new Promise((resolve, reject) => {
      const child = spawn(process.execPath, args, {
        cwd: folderOf(example),
        env: { ...process.env, ...ENV },
      });
      const close = () =>
        new Promise((closed) => {
          child.once('close', closed);
          child.kill();
        });
      let said = '';
      const hear = (text) => {
        said += text;
        const address = said.match(/http:\/\/localhost:\d+/)?.[0];
        if (address) resolve({ address: `${address}/`, close });
      };
      child.stdout.on('data', hear);
      child.stderr.on('data', hear);
      child.once('close', () => reject(new Error(`it ended: ${said}`)));
    });

/** Built once more, otherwise. */
const rebuilt = (example, script, serving) => async () => {
  await must(['run', script], folderOf(example));
  return serving();
};

const NEXT = ['node_modules/next/dist/bin/next', 'start', '--port', String(PORT)];
const NEXT_DEV = ['node_modules/next/dist/bin/next', 'dev', '--port', String(PORT)];
const VITE = ['node_modules/vite/bin/vite.js', '--port', String(PORT)];
const NG = ['node_modules/@angular/cli/bin/ng.js', 'serve', '--port', String(PORT)];

/** React says so of each tag that it does not know; x3dom's have no hyphen. */
const REACT_SAYS = ['is unrecognized in this browser'];

/** An edit may make the canvas anew. x3dom gives no context back: the browser does, when it collects what is gone. */
const HOT_SAYS = ['Too many active WebGL contexts'];

/** A component is edited while it runs; what else holds of the example holds as it is built. */
const hot = (example, command, ...path) => ({
  served: server(example, ...command),
  facts: hotFacts(example, ...path),
  says: HOT_SAYS,
});

/** By name of example: the ways in which it is served, and what its framework always says there. */
export const RUNS = {
  next: {
    built: { served: server('next', ...NEXT), more: [...ROUTES, ...SERVED] },
    'built by webpack': {
      served: rebuilt('next', 'build:webpack', server('next', ...NEXT)),
      more: [...ROUTES, ...SERVED],
    },
    'in its dev server': {
      served: server('next', ...NEXT_DEV),
      facts: SERVED,
      says: REACT_SAYS,
    },
  },
  angular: {
    built: { served: files('angular', 'dist') },
    'in its dev server': hot('angular', NG, 'src', 'app', 'scene.html'),
  },
  lit: { built: { served: files('lit', 'dist') } },
  plain: { 'as it is': { served: files('plain') } },
  preact: { built: { served: files('preact', 'dist') } },
  react: {
    built: { served: files('react', 'dist') },
    'in its dev server, in strict mode': {
      served: server('react', ...VITE),
      more: hotFacts('react', 'src', 'Scene.tsx'),
      says: [...REACT_SAYS, ...HOT_SAYS],
    },
  },
  solid: {
    built: { served: files('solid', 'dist') },
    'in its dev server': hot('solid', VITE, 'src', 'Scene.tsx'),
  },
  starter: {
    built: { served: files('starter', 'dist'), facts: STARTER },
    'in its dev server': { served: server('starter', ...VITE), facts: STARTER },
  },
  svelte: {
    built: { served: files('svelte', 'dist') },
    'in its dev server': hot('svelte', VITE, 'src', 'Scene.svelte'),
  },
  vue: {
    built: { served: files('vue', 'dist') },
    'in its dev server': hot('vue', VITE, 'src', 'Blocks.vue'),
  },
};
