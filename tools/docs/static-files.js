// Files as they are, for the test server and for `npm start`.
import { statSync } from 'node:fs';
import { extname, join, resolve, sep } from 'node:path';

const TYPES = {
  '.css': 'text/css; charset=utf-8',
  '.html': 'text/html; charset=utf-8',
  '.ico': 'image/x-icon',
  '.jpg': 'image/jpeg',
  '.js': 'text/javascript; charset=utf-8',
  '.json': 'application/json; charset=utf-8',
  '.map': 'application/json; charset=utf-8',
  '.mjs': 'text/javascript; charset=utf-8',
  '.png': 'image/png',
  '.svg': 'image/svg+xml',
  '.wasm': 'application/wasm',
  '.woff2': 'font/woff2',
  '.x3d': 'model/x3d+xml; charset=utf-8',
  '.xhtml': 'application/xhtml+xml; charset=utf-8',
};

/** What can't be decoded is the name of no file. */
function decoded(urlPath) {
  try {
    return decodeURIComponent(urlPath);
  } catch {
    return urlPath;
  }
}

/** The file for a URL path below `folder`, with its media type; undefined where there is none. */
export function findFile(folder, urlPath) {
  const root = resolve(folder);
  const file = join(root, decoded(urlPath));
  if (file !== root && !file.startsWith(root + sep)) return undefined;
  const stat = statSync(file, { throwIfNoEntry: false });
  if (stat?.isDirectory()) return findFile(folder, join(urlPath, 'index.html'));
  if (!stat?.isFile()) return undefined;
  return { file, type: TYPES[extname(file)] ?? 'application/octet-stream' };
}

/** Answers pages that are no files, by their paths. */
const madePages = (made) => ({
  name: 'made-pages',
  configurePreviewServer({ middlewares }) {
    middlewares.use(({ url }, response, next) => {
      if (!Object.hasOwn(made, url)) return next();
      response.setHeader('content-type', TYPES['.html']);
      response.end(made[url]);
    });
  },
});

/** Serves a folder on `port`, or on the next one that is free. `made`: the text of pages that are no files, by path. */
export async function serve(folder, port, made = {}) {
  const { preview } = await import('vite');
  const server = await preview({
    configFile: false,
    logLevel: 'error',
    // What is not there is answered by 404, and not by the folder's index.html.
    appType: 'mpa',
    plugins: [madePages(made)],
    build: { outDir: resolve(folder) },
    // Scenes of the playground stand in a sandbox, which is another origin: what they bring in by name is asked for so.
    preview: { port, host: true, cors: true },
  });
  return { port: server.httpServer.address().port, close: () => server.close() };
}
