import { createServer, type IncomingMessage, type ServerResponse } from 'node:http';
import type { AddressInfo } from 'node:net';
import { setTimeout as wait } from 'node:timers/promises';
// @ts-expect-error plain JavaScript
import { openBrowser } from '../../tools/docs/open-browser.js';

/** A media type, and what is sent with it. */
export type Answer = readonly [type: string, content: string | Buffer];

export interface AskedPages {
  /** Of a path with its query; '/' is the page that the browser is opened at. */
  answer(url: string): Answer | undefined;
  /** Sent with all of them. */
  headers?: Readonly<Record<string, string>>;
  /** They need WebGL. */
  draws?: boolean;
}

interface Opened {
  ended: Promise<unknown>;
  close(): Promise<void>;
}

async function bodyOf(request: IncomingMessage): Promise<string> {
  let text = '';
  for await (const part of request) text += String(part);
  return text;
}

/** A browser that nobody steers: its page fetches `/next` to hear what is asked, and posts what it found to `/found`. */
export class AskedBrowser {
  /** As the browser says itself. */
  version = '';
  readonly #pages: AskedPages;
  readonly #server = createServer((request, response) => void this.#answer(request, response));
  #opened: Opened | undefined;
  /** Of a page that waits for the next question, and of who waits for a page. */
  #idle: ServerResponse | undefined;
  #waiting: ((page: ServerResponse) => void) | undefined;
  #found: ((text: string) => void) | undefined;

  private constructor(pages: AskedPages) {
    this.#pages = pages;
  }

  static async open(name: string, pages: AskedPages): Promise<AskedBrowser> {
    const browser = new AskedBrowser(pages);
    await new Promise<void>((resolve) => browser.#server.listen(0, '127.0.0.1', resolve));
    const { port } = browser.#server.address() as AddressInfo;
    const { draws } = pages;
    browser.#opened = (await openBrowser(name, `http://127.0.0.1:${port}/`, { draws })) as Opened;
    return browser;
  }

  async #answer(request: IncomingMessage, response: ServerResponse): Promise<void> {
    const { url = '/', headers } = request;
    if (url === '/next') {
      this.version = /(?:Chrome|Firefox|Version)\/([\d.]+)/.exec(headers['user-agent']!)?.[1] ?? '';
      if (this.#waiting) this.#waiting(response);
      else this.#idle = response;
    } else if (url === '/found') {
      const found = await bodyOf(request);
      response.end();
      this.#found!(found);
    } else this.#send(url, response);
  }

  #send(url: string, response: ServerResponse): void {
    const answer = this.#pages.answer(url);
    if (!answer) return void response.writeHead(404).end();
    for (const [name, value] of Object.entries(this.#pages.headers ?? {}))
      response.setHeader(name, value);
    response.setHeader('content-type', answer[0]).end(answer[1]);
  }

  async #next(): Promise<ServerResponse> {
    const page =
      this.#idle ?? (await new Promise<ServerResponse>((resolve) => (this.#waiting = resolve)));
    this.#idle = this.#waiting = undefined;
    return page;
  }

  /** Asks, for at most so many milliseconds; `meanwhile` begins here when it has begun there. */
  async ask(question: string, patience: number, meanwhile = async () => {}): Promise<string> {
    const found = new Promise<string>((resolve) => (this.#found = resolve));
    const failed = this.#failure(patience);
    const page = await Promise.race([this.#next(), failed]);
    await new Promise<void>((resolve) => page.end(question, resolve));
    await meanwhile();
    return Promise.race([found, failed]);
  }

  /** Rejects when the browser is gone, or takes too long. */
  async #failure(patience: number): Promise<never> {
    const late = wait(patience, 'took too long', { ref: false });
    const gone = this.#opened!.ended.then(() => 'the browser ended');
    throw new Error(await Promise.race([late, gone]));
  }

  async close(): Promise<void> {
    await this.#opened?.close();
    this.#server.closeAllConnections();
    this.#server.close();
  }
}
