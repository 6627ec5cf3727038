import { readFileSync } from 'node:fs';
import { join } from 'node:path';

/** The file of the package, made part of the build. */
export const dynamic = 'force-static';

export const GET = () =>
  new Response(readFileSync(join(process.cwd(), 'node_modules/x3dom/x3dom.js')), {
    headers: { 'content-type': 'text/javascript; charset=utf-8' },
  });
