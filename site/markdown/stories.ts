// The stories beside the site's sources, while these are served: what was built of them last, or a word that they come.
import { createReadStream } from 'node:fs';
import type { UserConfig } from 'vitepress';
// @ts-expect-error plain JavaScript
import { findFile } from '../../tools/docs/static-files.js';
// @ts-expect-error plain JavaScript
import { STORIES } from '../../tools/docs/stories.js';

/** Of the Vite that VitePress brings. */
type Plugins = NonNullable<NonNullable<UserConfig['vite']>['plugins']>;
type Plugin = Extract<Plugins[number], { name: string }>;

/** Looks again by itself: it stands in the frames of reference pages, too. */
const COMING = `<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta http-equiv="refresh" content="3">
<title>Stories</title>
<style>:root { color-scheme: light dark; font: 16px/1.5 system-ui, sans-serif } body { margin: 2rem }</style>
<p>The stories are not built yet. <code>npm start</code> builds them behind the documentation, in a minute or two; this page
shows them as soon as they are there.`;

export const storiesBeside = (base: string): Plugin => ({
  name: 'stories-beside',
  configureServer({ middlewares }) {
    middlewares.use(`${base}stories`, (request, response, next) => {
      const path = new URL(request.url!, 'http://localhost').pathname;
      const found = findFile(STORIES, path) as { file: string; type: string } | undefined;
      if (found) {
        response.setHeader('content-type', found.type);
        return createReadStream(found.file).pipe(response);
      }
      if (findFile(STORIES, '/index.html')) return next();
      response.setHeader('content-type', 'text/html; charset=utf-8');
      response.end(COMING);
    });
  },
});
