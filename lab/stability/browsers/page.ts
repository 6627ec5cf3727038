import { readFileSync } from 'node:fs';
import { createServer, type IncomingMessage, type ServerResponse } from 'node:http';
import type { AddressInfo } from 'node:net';
import { setTimeout as wait } from 'node:timers/promises';
import { build } from 'esbuild';
// @ts-expect-error plain JavaScript
import { PLATFORMS } from '../../../tools/bundle-tests.js';
// @ts-expect-error plain JavaScript
import { openBrowser } from '../../../tools/open-browser.js';
import type { LevelName } from '../../../physics-core/inside.js';
import type { Cell } from '../case.js';
import { fromText, toText } from '../json.js';

/** A cell that a page is asked for. */
export interface Asked {
  id: string;
  level: LevelName;
}

interface Opened {
  ended: Promise<unknown>;
  close(): Promise<void>;
}

/** A worker, so that no browser takes a long cell for a page that hangs. */
const HTML = `<!DOCTYPE html>
<meta charset="utf-8">
<title>Hard cases</title>
<script>new Worker('/cells.js', { type: 'module' })</script>`;

/** Milliseconds that one cell may take. */
const PATIENCE = 5 * 60_000;

const WASM = 'node_modules/ammojs-typed/ammo/ammo.wasm.wasm';

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

async function bodyOf(request: IncomingMessage): Promise<string> {
  let text = '';
  for await (const part of request) text += String(part);
  return text;
}

/** One page of a browser, which runs cells as it is asked for them. */
export class CellPage {
  /** As the browser says itself. */
  version = '';
  readonly #server = createServer((request, response) => void this.#answer(request, response));
  readonly #files: Record<string, [type: string, content: string | Buffer]>;
  #browser: Opened | undefined;
  /** Waits for the next cell. */
  #waiting: ((response: ServerResponse) => void) | undefined;
  #idle: ServerResponse | undefined;
  #found: ((cell: Cell) => void) | undefined;

  private constructor(code: string) {
    this.#files = {
      '/': ['text/html', HTML],
      '/cells.js': ['text/javascript', code],
      '/ammo.wasm': ['application/wasm', readFileSync(WASM)],
    };
  }

  static async open(name: string): Promise<CellPage> {
    const page = new CellPage(await bundle());
    await new Promise<void>((resolve) => page.#server.listen(0, '127.0.0.1', resolve));
    const { port } = page.#server.address() as AddressInfo;
    page.#browser = (await openBrowser(name, `http://127.0.0.1:${port}/`)) as Opened;
    return page;
  }

  async #answer(request: IncomingMessage, response: ServerResponse): Promise<void> {
    const { url = '/', headers } = request;
    const file = this.#files[url];
    if (file) response.setHeader('content-type', file[0]).end(file[1]);
    else if (url === '/next') {
      this.version = /(?:Chrome|Firefox|Version)\/([\d.]+)/.exec(headers['user-agent']!)?.[1] ?? '';
      if (this.#waiting) this.#waiting(response);
      else this.#idle = response;
    } else if (url === '/found') {
      const cell = fromText(await bodyOf(request)) as Cell;
      response.end();
      this.#found!(cell);
    } else response.writeHead(404).end();
  }

  async #next(): Promise<ServerResponse> {
    const response =
      this.#idle ?? (await new Promise<ServerResponse>((resolve) => (this.#waiting = resolve)));
    this.#idle = this.#waiting = undefined;
    return response;
  }

  /** Runs a cell there; `meanwhile` begins here when it has begun there. */
  async run(asked: Asked, meanwhile: () => Promise<void> = async () => {}): Promise<Cell> {
    const found = new Promise<Cell>((resolve) => (this.#found = resolve));
    const failed = this.#failure(asked);
    const response = await Promise.race([this.#next(), failed]);
    await new Promise<void>((resolve) => response.end(toText(asked), resolve));
    await meanwhile();
    return Promise.race([found, failed]);
  }

  /** Rejects when the browser is gone, or takes too long. */
  async #failure({ id, level }: Asked): Promise<never> {
    const late = wait(PATIENCE, 'took too long', { ref: false });
    const gone = this.#browser!.ended.then(() => 'the browser ended');
    throw new Error(`${id} at ${level}: ${await Promise.race([late, gone])}`);
  }

  async close(): Promise<void> {
    await this.#browser?.close();
    this.#server.closeAllConnections();
    this.#server.close();
  }
}
