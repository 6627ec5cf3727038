import { readdirSync, writeFileSync } from 'node:fs';
import { chromium, type Browser } from 'playwright';
// @ts-expect-error plain JavaScript
import { CHROMIUM_ARGUMENTS, findChromium } from '../../tools/test/browsers.js';
import { inPageBundle } from '../in-page-bundle.js';
import type { Found } from './in-page/measure.js';
import { addressOf, FORMS, servePages, type Form } from './pages.js';

/**
 * Opens each X3D file of a folder in Chromium and prints what its bodies do: `npm run lab -- content -- <folder>`, with
 * `--only <words>` those whose name has these words in it, `--live <seconds>` at the page's own pace first, so that what
 * a TimeSensor drives goes on, `--json <file>` all that was found.
 */
interface Row extends Partial<Found> {
  file: string;
  form: Form;
  said: string[];
  failed?: string;
}

/** Seconds of the world's time, and milliseconds that a file may take. */
const [SECONDS, PATIENCE] = [3, 60_000];

const IN_PAGE = await inPageBundle('lab/content/in-page/measure.ts');

const option = (name: string): string | undefined => {
  const at = process.argv.indexOf(`--${name}`);
  return at < 0 ? undefined : process.argv[at + 1];
};

const late = (): Promise<never> =>
  new Promise((_, reject) => setTimeout(reject, PATIENCE, new Error('took too long')).unref());

async function measure(browser: Browser, address: string, row: Row): Promise<Row> {
  const page = await browser.newPage();
  page.on('console', (message) => row.said.push(`${message.type()} ${message.text()}`));
  page.on('pageerror', ({ message }) => row.said.push(`exception ${message}`));
  try {
    const live = Number(option('live') ?? 0);
    const measured = page
      .goto(address)
      .then(
        () => page.evaluate(`${IN_PAGE}; measureContent(${SECONDS}, ${live})`) as Promise<Found>,
      );
    return { ...row, ...(await Promise.race([measured, late()])) };
  } catch (error) {
    return { ...row, failed: String(error).split('\n')[0]! };
  } finally {
    await page.close({ runBeforeUnload: false });
  }
}

const millimetres = (metres = 0): string => (metres * 1000).toFixed(metres < 0.1 ? 3 : 0);

function print(row: Row): void {
  const { file, form, failed, said } = row;
  if (failed) return console.log(`${file} | ${form} | ${failed}`);
  const far = Math.max(0, ...row.moved!.map(([, metres]) => metres));
  const codes = row.problems!.map((problem) => problem.split(':')[0]!);
  const told = [...new Set(codes)].map(
    (code) =>
      `${code}${codes.length > 1 ? ` ×${codes.filter((other) => other === code).length}` : ''}`,
  );
  console.log(
    [
      file,
      form,
      `${row.elements} elements, ${row.bodies} bodies, ${row.joints} joints`,
      `${row.moved!.length} moved, ${far.toFixed(2)} m, lowest ${Number.isFinite(row.lowest!) ? row.lowest!.toFixed(2) : '–'}, ${row.fastest!.toFixed(2)} m/s`,
      `gap ${millimetres(row.gap)} mm`,
      row.finite ? '' : 'NOT FINITE',
      told.join(', '),
      `${said.length} said`,
    ].join(' | '),
  );
}

const folder = process.argv[2];
if (!folder) throw new Error('Which folder? npm run lab -- content -- <folder>');
const only = option('only') ?? '';
const forms = (option('forms')?.split(',') ?? FORMS) as Form[];
const files = readdirSync(folder).filter(
  (file) => /\.(x3d|json)$/.test(file) && file.includes(only),
);
const server = await servePages(folder);
const browser = await chromium.launch({
  executablePath: (await findChromium()) as string,
  args: CHROMIUM_ARGUMENTS as string[],
});
const rows: Row[] = [];
for (const file of files)
  for (const form of forms.filter((form) => form === 'inline' || file.endsWith('.x3d'))) {
    const row = await measure(browser, addressOf(server, form, file), { file, form, said: [] });
    rows.push(row);
    print(row);
  }
const json = option('json');
if (json) writeFileSync(json, `${JSON.stringify(rows, null, 1)}\n`);
await browser.close();
server.close();
