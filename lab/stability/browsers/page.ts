import { build } from 'esbuild';
// @ts-expect-error plain JavaScript
import { PLATFORMS, wasmOfTests } from '../../../tools/test/bundle-tests.js';
import type { LevelName } from '../../../physics-core/inside.js';
import { AskedBrowser, type Answer } from '../../run/asked-browser.js';
import type { Cell } from '../case.js';
import { fromText, toText } from '../json.js';

/** A cell that a page is asked for. */
export interface Asked {
  id: string;
  level: LevelName;
}

/** A worker, so that no browser takes a long cell for a page that hangs. */
const HTML = `<!DOCTYPE html>
<meta charset="utf-8">
<title>Hard cases</title>
<script>new Worker('/cells.js', { type: 'module' })</script>`;

/** Milliseconds that one cell may take. */
const PATIENCE = 5 * 60_000;

async function bundle(): Promise<string> {
  const { outputFiles } = await build({
    ...PLATFORMS.browser,
    splitting: false,
    entryPoints: ['lab/stability/browsers/cells.ts'],
    bundle: true,
    ignoreAnnotations: true,
    format: 'esm',
    tsconfig: 'tsconfig.json',
    logLevel: 'warning',
    write: false,
  });
  return outputFiles![0]!.text;
}

/** One page of a browser, which runs cells as it is asked for them. */
export class CellPage {
  readonly #browser: AskedBrowser;

  private constructor(browser: AskedBrowser) {
    this.#browser = browser;
  }

  static async open(name: string): Promise<CellPage> {
    const files: Record<string, Answer> = {
      '/': ['text/html', HTML],
      '/cells.js': ['text/javascript', await bundle()],
      '/ammo.wasm': ['application/wasm', wasmOfTests()],
    };
    return new CellPage(await AskedBrowser.open(name, { answer: (url) => files[url] }));
  }

  /** As the browser says itself. */
  get version(): string {
    return this.#browser.version;
  }

  /** Runs a cell there; `meanwhile` begins here when it has begun there. */
  async run(asked: Asked, meanwhile?: () => Promise<void>): Promise<Cell> {
    try {
      return fromText(await this.#browser.ask(toText(asked), PATIENCE, meanwhile)) as Cell;
    } catch (error) {
      throw new Error(`${asked.id} at ${asked.level}: ${(error as Error).message}`);
    }
  }

  close(): Promise<void> {
    return this.#browser.close();
  }
}
