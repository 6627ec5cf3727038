// npm run write -- picture: the README's moving picture, docs/pictures/wrecking-ball.webp, from examples/wrecking-ball.html as it
// runs in Chromium. dist/ must be built.
import { writeFileSync } from 'node:fs';
import { chromium, type Page } from 'playwright';
import { CHROMIUM_ARGUMENTS, ensureChromium } from '../test/browsers.js';
import { animatedWebp } from './picture/animated-webp.js';
// @ts-expect-error plain JavaScript
import { serve } from './static-files.js';

const SCENE = 'examples/wrecking-ball.html';
const PICTURE = 'docs/pictures/wrecking-ball.webp';

const SIZE = { width: 560, height: 316 };
const PER_SECOND = 12;
const SECONDS = 4.5;
/** Of WebP, from 0 to 1. */
const QUALITY = 0.45;
/** Milliseconds in which x3dom has drawn what moved, without a graphics card. */
const DRAWN = 250;

/** Chromium packs pictures as WebP; the page that shows one packs it. */
const packed = async (page: Page, png: Buffer): Promise<Buffer> => {
  const text = await page.evaluate(
    `(async () => {
      const image = new Image();
      image.src = 'data:image/png;base64,${png.toString('base64')}';
      await image.decode();
      const canvas = Object.assign(document.createElement('canvas'), { width: image.width, height: image.height });
      canvas.getContext('2d', { alpha: false }).drawImage(image, 0, 0);
      return canvas.toDataURL('image/webp', ${QUALITY});
    })()`,
  );
  return Buffer.from((text as string).split(',')[1]!, 'base64');
};

/** The running scene, stepped by hand: every picture is as far from the last one as time says. */
async function stills(page: Page): Promise<Buffer[]> {
  const world = `document.querySelector('x3d-rigid-body').world`;
  await page.evaluate(`${world}.ready.then((world) => { world.paused = true; world.reset(); })`);
  const found: Buffer[] = [];
  for (let i = 0; i < PER_SECOND * SECONDS; i++) {
    if (i > 0) await page.evaluate(`${world}.advance(1 / ${PER_SECOND})`);
    await page.waitForTimeout(DRAWN);
    found.push(await packed(page, await page.screenshot()));
  }
  return found;
}

async function main(): Promise<void> {
  const executablePath = await ensureChromium();
  const { port, close } = await serve('.', 6240);
  const browser = await chromium.launch({ executablePath, args: CHROMIUM_ARGUMENTS });
  const page = await browser.newPage({ viewport: SIZE, colorScheme: 'light' });
  await page.goto(`http://localhost:${port}/${SCENE}`);
  await page.locator('x3d canvas').waitFor();
  const frames = await stills(page);
  const picture = animatedWebp(frames, SIZE.width, SIZE.height, Math.round(1000 / PER_SECOND));
  writeFileSync(PICTURE, picture);
  console.log(`${PICTURE}: ${frames.length} pictures, ${Math.round(picture.length / 1000)} kB`);
  await browser.close();
  await close();
}

await main();
