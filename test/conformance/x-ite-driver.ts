import { chromium, type Browser, type Page } from 'playwright';
// @ts-expect-error plain JavaScript
import { findChromium } from '../../tools/test/browsers.js';
// @ts-expect-error plain JavaScript
import { serve } from '../../tools/docs/static-files.js';
import { particleTypes } from '../../physics-core/particles.js';
import { FRAME } from './checks.js';
import type { Fact, NodeData, Stage } from './fact.js';
import { definedFirst, markup, typesByName } from './markup.js';

/** WebGL without a graphics card, also as root. */
const ARGUMENTS = [
  '--no-sandbox',
  '--disable-dev-shm-usage',
  '--use-gl=angle',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
];

const HTML = `<!DOCTYPE html>
<meta charset="utf-8">
<script src="/test/conformance/x-ite-page.js"></script>
<script src="/node_modules/x_ite/dist/x_ite.min.js"></script>
<x3d-canvas style="width: 16px; height: 16px"></x3d-canvas>`;

/** Seconds of real time that one call may take. */
const PATIENCE = 20;

function asX3D(scene: NodeData[]): string {
  const spelling = { types: typesByName(scene), tag: (type: string) => type };
  const nodes = definedFirst(scene).map((node) => markup(node, spelling));
  return `<X3D profile="Full" version="4.0"><Scene>${nodes.join('')}</Scene></X3D>`;
}

/** Whether the facts of a node ask for nothing but X3D's own fields: none of those says where particles are. */
export const tells = (node: string): boolean => !(node in particleTypes);

/** X_ITE in a headless Chromium; its clock is ours. */
export class XIte {
  readonly #browser: Browser;
  readonly #address: string;
  #page: Page | undefined;

  private constructor(browser: Browser, address: string) {
    this.#browser = browser;
    this.#address = address;
  }

  static async start(): Promise<XIte> {
    const { port } = (await serve('.', 8200)) as { port: number };
    const executablePath = await findChromium();
    const browser = await chromium.launch({ executablePath, args: ARGUMENTS });
    return new XIte(browser, `http://localhost:${port}/x-ite.html`);
  }

  /** Its version, and that of the browser it runs in. */
  async version(): Promise<string> {
    const own = (await this.#call('version')) as string;
    return `${own} in Chromium ${this.#browser.version()}`;
  }

  async #open(): Promise<Page> {
    const page = await this.#browser.newPage({ viewport: { width: 64, height: 64 } });
    await page.route(this.#address, (route) =>
      route.fulfill({ contentType: 'text/html', body: HTML }),
    );
    await page.goto(this.#address);
    return page;
  }

  async #call(method: string, ...values: unknown[]): Promise<unknown> {
    const page = (this.#page ??= await this.#open());
    let timer: NodeJS.Timeout | undefined;
    const late = new Promise((_, reject) => {
      const fail = (): void => reject(new Error(`no answer within ${PATIENCE} s`));
      timer = setTimeout(fail, PATIENCE * 1000);
    });
    try {
      const answer = page.evaluate(
        ([name, list]) => (globalThis as any).conformance[name](...list),
        [method, values] as const,
      );
      return await Promise.race([answer, late]);
    } catch (error) {
      // Playwright adds where in the page it happened.
      const [said] = String((error as Error).message).split('\n');
      throw new Error(said!.replace(/^page\.evaluate: (Error: )?/, ''));
    } finally {
      clearTimeout(timer);
    }
  }

  readonly open = async ({ scene }: Fact): Promise<Stage> => {
    await this.#call('show', asX3D(scene));
    return {
      get: (def, field) => this.#call('get', def, field),
      set: async (def, field, value) => void (await this.#call('set', def, field, value)),
      advance: async (seconds) => void (await this.#call('advance', Math.round(seconds / FRAME))),
      close: async () => {},
    };
  };

  /** After something went wrong nothing is left of it. */
  async renew(): Promise<void> {
    await this.#page?.close();
    this.#page = undefined;
  }

  async stop(): Promise<void> {
    await this.#browser.close();
  }
}
