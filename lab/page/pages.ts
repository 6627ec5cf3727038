import { readFileSync } from 'node:fs';
import { build } from 'esbuild';
// @ts-expect-error plain JavaScript
import { findFile } from '../../tools/static-files.js';
import { libraryOf } from './libraries/index.js';
import { SCENES } from './scene.js';

type Answer = readonly [type: string, content: string | Buffer];

/** The driver's page; frames lie side by side, all in sight. */
const DRIVER = `<!DOCTYPE html><meta charset="utf-8"><title>Pages</title>
<style>body { margin: 0 } iframe { width: 250px; height: 190px; border: 0 }</style>
<script type="module" src="/driver.js"></script>`;

async function bundle(name: string): Promise<string> {
  const { outputFiles } = await build({
    entryPoints: [`lab/page/in-page/${name}.ts`],
    bundle: true,
    format: 'iife',
    target: 'es2022',
    tsconfig: 'tsconfig.json',
    logLevel: 'warning',
    write: false,
  });
  return outputFiles[0]!.text;
}

export interface PageName {
  library: string;
  scene: string;
  count: number;
}

export const addressOf = ({ library, scene, count }: PageName): string =>
  `/page?${new URLSearchParams({ library, scene, count: String(count) })}`;

/** All that a browser asks for while it is measured: no network is needed. */
export class Pages {
  readonly #scripts: Record<string, string>;

  private constructor(scripts: Record<string, string>) {
    this.#scripts = scripts;
  }

  static async make(): Promise<Pages> {
    return new Pages({ '/hooks.js': await bundle('hooks'), '/driver.js': await bundle('driver') });
  }

  answer(url: string): Answer | undefined {
    const { pathname, search, searchParams } = new URL(url, 'http://localhost');
    if (pathname === '/') return ['text/html', DRIVER];
    const script = this.#scripts[pathname];
    if (script) return ['text/javascript', script];
    if (pathname === '/page' || pathname === '/file') {
      const library = libraryOf(searchParams.get('library')!);
      const scene = SCENES[searchParams.get('scene')!]!(Number(searchParams.get('count')));
      if (pathname === '/file') return ['model/x3d+xml', library.file!(scene)];
      return [library.type, library.page(scene, `/page${search}`)];
    }
    const found = findFile('.', pathname) as { file: string; type: string } | undefined;
    return found && [found.type, readFileSync(found.file)];
  }
}
