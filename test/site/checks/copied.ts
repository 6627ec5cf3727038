// What the first page says to copy does what it says: saved to an empty folder, with the two files that it links to beside it,
// and opened from disk, the box falls and comes to rest.
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type { Browser } from 'playwright';

/** The text under the heading, and the addresses of what is to lie beside it. */
interface Copied {
  text: string;
  files: string[];
}

async function copied(browser: Browser, address: string): Promise<Copied> {
  const tab = await browser.newPage();
  await tab.goto(`${address}/`);
  const text = await tab.locator('#copy-this ~ div[class*=language-html] code').first().innerText();
  const files = await tab
    .locator('#copy-this ~ p a[download]')
    .evaluateAll((links) => links.map((link) => (link as HTMLAnchorElement).href));
  await tab.close();
  return { text, files };
}

/** How high the box is after six seconds, metres. */
async function heightIn(browser: Browser, file: string): Promise<number> {
  const tab = await browser.newPage();
  await tab.goto(pathToFileURL(file).href);
  const height = await tab.evaluate(async () => {
    const body = document.querySelector('x3d-rigid-body') as unknown as {
      world: { ready: Promise<void>; paused: boolean; advance(seconds: number): void };
      position: number[];
    };
    await body.world.ready;
    body.world.paused = true;
    body.world.advance(6);
    return body.position[1]!;
  });
  await tab.close();
  return height;
}

export async function miscopied(browser: Browser, address: string): Promise<string[]> {
  const { text, files } = await copied(browser, address);
  const folder = mkdtempSync(join(tmpdir(), 'falling-box-'));
  try {
    writeFileSync(join(folder, 'falling-box.html'), text);
    for (const file of files) {
      const bytes = new Uint8Array(await (await fetch(file)).arrayBuffer());
      writeFileSync(join(folder, basename(new URL(file).pathname)), bytes);
    }
    const height = await heightIn(browser, join(folder, 'falling-box.html'));
    return Math.abs(height - 0.5) < 0.01 ? [] : [`the copied box lies at ${height} m, not 0.5 m`];
  } catch (error) {
    return [`the page to copy does not run: ${(error as Error).message}`];
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
