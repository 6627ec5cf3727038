import { readFileSync } from 'node:fs';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
// @ts-expect-error plain JavaScript
import { findFile } from '../../tools/docs/static-files.js';

/** How a file comes into a page: named by an Inline (XML or JSON), or its XML pasted into an XHTML document. */
export const FORMS = ['inline', 'xhtml'] as const;
export type Form = (typeof FORMS)[number];

const SCRIPTS = `<script src="/node_modules/x3dom/x3dom.js"></script>
<script src="/dist/x3d-physics.classic.js"></script>`;

const inlinePage = (
  file: string,
): string => `<!DOCTYPE html><meta charset="utf-8"><title>Content</title>
${SCRIPTS}
<x3d width="300px" height="200px"><scene><inline url="/file/${encodeURIComponent(file)}"></inline></scene></x3d>`;

/** The element alone: an XML declaration and a DOCTYPE stand only at the beginning of a document. */
const pasted = (xml: string): string => /<X3D\b[\s\S]*<\/X3D>/.exec(xml)?.[0] ?? xml;

const xhtmlPage = (xml: string): string => `<html xmlns="http://www.w3.org/1999/xhtml"><head>
<title>Content</title>
${SCRIPTS}
</head><body>${pasted(xml)}</body></html>`;

type Answer = [type: string, content: string | Buffer];

function fileAt(folder: string, path: string): Answer | undefined {
  const found = findFile(folder, path) as { file: string; type: string } | undefined;
  return found && [found.type, readFileSync(found.file)];
}

function pageOf(folder: string, form: Form, file: string): Answer | undefined {
  if (form === 'inline') return ['text/html', inlinePage(file)];
  const found = fileAt(folder, file);
  return found && ['application/xhtml+xml', xhtmlPage(found[1].toString())];
}

function answer(folder: string, path: string): Answer | undefined {
  const [, kind, ...rest] = path.split('/');
  const file = decodeURIComponent(rest.join('/'));
  if (kind === 'inline' || kind === 'xhtml') return pageOf(folder, kind, file);
  return kind === 'file' ? fileAt(folder, file) : fileAt('.', path);
}

export const addressOf = (server: Server, form: Form, file: string): string =>
  `http://127.0.0.1:${(server.address() as AddressInfo).port}/${form}/${encodeURIComponent(file)}`;

/** Serves each file of the folder in each form, with the built library and x3dom. */
export async function servePages(folder: string): Promise<Server> {
  const server = createServer((request, response) => {
    const found = answer(folder, request.url!);
    if (!found) return void response.writeHead(404).end();
    response.setHeader('content-type', found[0]).end(found[1]);
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  return server;
}
