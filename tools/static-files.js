// Files as they are, for the test server and for `npm start`.
import { createReadStream, statSync } from 'node:fs';
import { createServer } from 'node:http';
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

/** The file for a URL path below `folder`, with its media type; undefined where there is none. */
export function findFile(folder, urlPath) {
  const root = resolve(folder);
  const file = join(root, decodeURIComponent(urlPath));
  if (file !== root && !file.startsWith(root + sep)) return undefined;
  const stat = statSync(file, { throwIfNoEntry: false });
  if (stat?.isDirectory()) return findFile(folder, join(urlPath, 'index.html'));
  if (!stat?.isFile()) return undefined;
  return { file, type: TYPES[extname(file)] ?? 'application/octet-stream' };
}

/** Serves a folder on `port`, or on the next one that is free. Answers the port. */
export function serve(folder, port) {
  const server = createServer((request, response) => {
    const found = findFile(folder, new URL(request.url, 'http://localhost').pathname);
    if (!found) return response.writeHead(404).end('Not found');
    response.writeHead(200, { 'content-type': found.type, 'cache-control': 'no-cache' });
    createReadStream(found.file).pipe(response);
  });
  return new Promise((resolvePort, reject) => {
    server.once('listening', () => resolvePort(server.address().port));
    server.on('error', (error) => {
      if (error.code === 'EADDRINUSE') server.listen(++port);
      else reject(error);
    });
    server.listen(port);
  });
}
