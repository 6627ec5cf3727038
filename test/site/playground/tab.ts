// The playground in a tab, as a person uses it: by typing and by its buttons.
import assert from 'node:assert/strict';
import type { Browser, Frame, Page } from 'playwright';
import { playgroundAddress } from '../../../site/playground/address.js';

/** Of a body. */
export interface Motion {
  position: number[];
  orientation: number[];
  linearVelocity: number[];
  angularVelocity: number[];
}

export interface Counts {
  bodies: number;
  created: number;
  patched: number;
  destroyed: number;
}

/** Milliseconds for which something may take its time. */
const PATIENCE = 15_000;

export class Tab {
  readonly errors: string[] = [];
  readonly page: Page;
  readonly address: string;

  constructor(page: Page, address: string) {
    this.page = page;
    this.address = address;
    page.on('pageerror', (error) => this.errors.push(error.message));
  }

  static async open(browser: Browser, address: string, markup?: string): Promise<Tab> {
    const page = await browser.newPage({ viewport: { width: 900, height: 520 } });
    const tab = new Tab(page, address);
    await tab.goTo(markup === undefined ? '/playground.html' : playgroundAddress(markup));
    return tab;
  }

  async goTo(path: string): Promise<void> {
    await this.page.goto(this.address + path);
    await this.page.waitForSelector('[data-ready]', { timeout: PATIENCE });
  }

  get scene(): Frame {
    return this.page.frames().find((frame) => frame !== this.page.mainFrame())!;
  }

  /** What was asked of the scene's page is done. */
  async settled(): Promise<void> {
    await this.page.waitForSelector('.scene[aria-busy="false"]', { timeout: PATIENCE });
  }

  async press(button: string): Promise<void> {
    await this.page.getByRole('button', { name: button, exact: true }).click();
    await this.settled();
  }

  async choose(example: string): Promise<void> {
    await this.page.getByLabel('Open an example').selectOption({ label: example });
    await this.settled();
  }

  /** What is said under the editor, line by line. */
  told(): Promise<string[]> {
    return this.page.locator('.told li').allInnerTexts();
  }

  async waitForTold(count: number): Promise<string[]> {
    const items = this.page.locator('.told li');
    await items.nth(count - 1).waitFor({ timeout: PATIENCE });
    const told = await this.told();
    assert.equal(told.length, count, told.join('\n'));
    return told;
  }

  /** The whole text, be it in sight or not. */
  text(): Promise<string> {
    return this.page.evaluate(() => {
      const content = document.querySelector('.cm-content') as Element & {
        cmTile: { view: { state: { doc: object } } };
      };
      return String(content.cmTile.view.state.doc);
    });
  }

  /** Selects the first such text in the editor. */
  async select(text: string): Promise<void> {
    const found = await this.page.evaluate((wanted) => {
      const content = document.querySelector('.cm-content') as HTMLElement & { cmTile: any };
      const { view } = content.cmTile;
      const at = String(view.state.doc).indexOf(wanted);
      if (at < 0) return false;
      view.focus();
      view.dispatch({ selection: { anchor: at, head: at + wanted.length }, scrollIntoView: true });
      return true;
    }, text);
    assert.ok(found, `the text has ${text}`);
  }

  /** Types in place of a text. */
  async replace(text: string, by: string): Promise<void> {
    await this.select(text);
    if (by) await this.page.keyboard.insertText(by);
    else await this.page.keyboard.press('Delete');
    await this.settled();
  }

  /** Waits until the worlds of the scene have started. */
  async started(): Promise<void> {
    await this.settled();
    await this.scene.waitForFunction(
      () => (window as any).worldOf(document.querySelector('x3d'))?.stats.bodies > 0,
      undefined,
      { timeout: PATIENCE },
    );
    // Without an answer: a world is too much to hand over.
    await this.scene.evaluate(async () => {
      await (window as any).worldOf(document.querySelector('x3d')).ready;
    });
  }

  async counts(): Promise<Counts> {
    await this.settled();
    return this.scene.evaluate(() => {
      const world = (window as any).worldOf(document.querySelector('x3d'));
      world.step(0);
      const { bodies, created, patched, destroyed } = world.stats;
      return { bodies, created, patched, destroyed };
    });
  }

  /** What the counts of the world have come to by what `does`. */
  async countsOf(does: () => Promise<unknown>): Promise<Counts> {
    const before = await this.counts();
    await does();
    const after = await this.counts();
    return {
      bodies: after.bodies - before.bodies,
      created: after.created - before.created,
      patched: after.patched - before.patched,
      destroyed: after.destroyed - before.destroyed,
    };
  }

  /** Of every body with an id. */
  async motions(): Promise<Record<string, Motion>> {
    await this.settled();
    return this.scene.evaluate(() =>
      Object.fromEntries(
        [...document.querySelectorAll<HTMLElement & Motion>('x3d-rigid-body[id]')].map((body) => {
          const { position, orientation, linearVelocity, angularVelocity } = body;
          return [body.id, { position, orientation, linearVelocity, angularVelocity }];
        }),
      ),
    );
  }

  /** Lets it fall for half a second, and stand there. */
  async runAndPause(): Promise<void> {
    await this.started();
    await this.press('Pause');
    await this.scene.evaluate(() => {
      const world = (window as any).worldOf(document.querySelector('x3d'));
      world.reset();
      world.step(60);
    });
  }

  /** The lines with a mark in the margin. */
  async markedLines(): Promise<number[]> {
    return this.page.evaluate(() =>
      [...document.querySelectorAll('.cm-lint-marker')].map((marker) => {
        const { top } = marker.closest('.cm-gutterElement')!.getBoundingClientRect();
        const line = [...document.querySelectorAll('.cm-lineNumbers .cm-gutterElement')].find(
          (each) => Math.abs(each.getBoundingClientRect().top - top) < 3,
        );
        return Number(line?.textContent);
      }),
    );
  }

  async waitForMarks(count: number): Promise<void> {
    await this.page.waitForFunction(
      (wanted) => document.querySelectorAll('.cm-lint-marker').length === wanted,
      count,
      { timeout: PATIENCE },
    );
  }
}
