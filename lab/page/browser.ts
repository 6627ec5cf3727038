import { createServer, type IncomingMessage, type ServerResponse } from 'node:http';
import type { AddressInfo } from 'node:net';
import { setTimeout as wait } from 'node:timers/promises';
// @ts-expect-error plain JavaScript
import { openBrowser } from '../../tools/open-browser.js';
import type { Asked, Found } from './asked.js';
import type { Pages } from './pages.js';

/** Milliseconds that one question may take. */
const PATIENCE = 10 * 60_000;

/** Each page loads all of its files anew, and its clock is as fine as the browser has it: it shares nothing. */
const HEADERS = {
  'cache-control': 'no-store',
  'cross-origin-opener-policy': 'same-origin',
  'cross-origin-embedder-policy': 'require-corp',
};

interface Opened {
  ended: Promise<unknown>;
  close(): Promise<void>;
}

async function bodyOf(request: IncomingMessage): Promise<string> {
  let text = '';
  for await (const part of request) text += String(part);
  return text;
}

/** A browser at the driver's page, which is asked one thing after the other. */
export class MeasuredBrowser {
  /** As it says itself. */
  version = '';
  readonly #pages: Pages;
  readonly #server = createServer((request, response) => void this.#answer(request, response));
  #opened: Opened | undefined;
  /** Of a driver that waits for what it is asked next, and of who waits for a driver. */
  #idle: ServerResponse | undefined;
  #waiting: ((driver: ServerResponse) => void) | undefined;
  #found: ((found: Found) => void) | undefined;

  private constructor(pages: Pages) {
    this.#pages = pages;
  }

  static async open(name: string, pages: Pages): Promise<MeasuredBrowser> {
    const browser = new MeasuredBrowser(pages);
    await new Promise<void>((resolve) => browser.#server.listen(0, '127.0.0.1', resolve));
    const { port } = browser.#server.address() as AddressInfo;
    const address = `http://127.0.0.1:${port}/`;
    browser.#opened = (await openBrowser(name, address, { draws: true })) as Opened;
    return browser;
  }

  async #answer(request: IncomingMessage, response: ServerResponse): Promise<void> {
    const { url = '/', headers } = request;
    if (url === '/next') {
      this.version = /(?:Chrome|Firefox|Version)\/([\d.]+)/.exec(headers['user-agent']!)?.[1] ?? '';
      if (this.#waiting) this.#waiting(response);
      else this.#idle = response;
      return;
    }
    if (url === '/found') {
      const found = JSON.parse(await bodyOf(request)) as Found;
      response.end();
      this.#found?.(found);
      return;
    }
    const answer = this.#pages.answer(url);
    for (const [name, value] of Object.entries(HEADERS)) response.setHeader(name, value);
    if (answer) response.setHeader('content-type', answer[0]).end(answer[1]);
    else response.writeHead(404).end();
  }

  async #driver(): Promise<ServerResponse> {
    const driver =
      this.#idle ?? (await new Promise<ServerResponse>((resolve) => (this.#waiting = resolve)));
    this.#idle = this.#waiting = undefined;
    return driver;
  }

  async ask(asked: Asked): Promise<Found> {
    const found = new Promise<Found>((resolve) => (this.#found = resolve));
    const failed = this.#failure(asked);
    const driver = await Promise.race([this.#driver(), failed]);
    driver.setHeader('content-type', 'application/json').end(JSON.stringify(asked));
    return Promise.race([found, failed]);
  }

  /** Rejects when the browser is gone, or takes too long. */
  async #failure(asked: Asked): Promise<never> {
    const late = wait(PATIENCE, 'took too long', { ref: false });
    const gone = this.#opened!.ended.then(() => 'the browser ended');
    throw new Error(`${JSON.stringify(asked)}: ${await Promise.race([late, gone])}`);
  }

  async close(): Promise<void> {
    await this.#opened?.close();
    this.#server.closeAllConnections();
    this.#server.close();
  }
}
