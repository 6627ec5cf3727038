// The site's own search, by keyboard: it finds a field by its name.
import type { Browser } from 'playwright';

const FIELD = 'suspensionErrorCorrection';
const PAGE = '/reference/DoubleAxisHingeJoint';

export async function notFound(browser: Browser, address: string): Promise<string[]> {
  const tab = await browser.newPage({ viewport: { width: 1280, height: 900 } });
  await tab.goto(`${address}/guide/which-file.html`);
  await tab.waitForFunction(() => '__vue_app__' in document.querySelector('#app')!);
  await tab.keyboard.press('Control+k');
  await tab.locator('#localsearch-input').fill(FIELD);
  const found = tab.locator(`.results a[href^="${PAGE}"]`).first();
  const there = await found.waitFor({ timeout: 15_000 }).then(
    () => true,
    () => false,
  );
  await tab.close();
  return there ? [] : [`the search for ${FIELD} does not find ${PAGE}`];
}
