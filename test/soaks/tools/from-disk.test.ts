import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright';

const EXAMPLE = 'examples/falling-box.html';
const LIBRARY = 'dist/x3d-physics.single.js';

/** What opens the page, or why nothing can. */
const browser = process.env.CHROME_PATH ?? '/usr/bin/chromium';
const missing = !existsSync(browser)
  ? `no Chromium at ${browser}`
  : !existsSync(LIBRARY) && `${LIBRARY} is not built`;

interface Seen {
  height: number;
  speed: number;
  problems: string[];
}

/** Runs in the page. */
async function letFall(): Promise<Seen> {
  const body = document.querySelector('x3d-rigid-body') as unknown as Element & {
    world: {
      ready: Promise<void>;
      paused: boolean;
      advance(s: number): void;
      problems: { code: string }[];
    };
    position: number[];
    linearVelocity: number[];
  };
  await body.world.ready;
  body.world.paused = true;
  body.world.advance(6);
  return {
    height: body.position[1]!,
    speed: Math.hypot(...body.linearVelocity),
    problems: body.world.problems.map(({ code }) => code).filter((code) => code !== 'lag'),
  };
}

test("the page in examples/ takes the two scripts that README's first example takes", () => {
  const [, html] = readFileSync('README.md', 'utf8').match(/```html\n(<!doctype html>[^]*?)```/)!;
  const scripts = (text: string): string[] =>
    [...text.matchAll(/<script src="(?:[^"]*\/)?([^"/]+)"/g)].map(([, name]) => name!);
  assert.deepEqual(scripts(readFileSync(EXAMPLE, 'utf8')), scripts(html!));
  assert.equal(scripts(html!).length, 2);
});

test(
  'a page opened from disk runs: the box comes to rest on the floor',
  { skip: missing },
  async () => {
    const opened = await chromium.launch({
      executablePath: browser,
      args: [
        '--no-sandbox',
        '--disable-dev-shm-usage',
        '--use-gl=angle',
        '--use-angle=swiftshader',
        '--enable-unsafe-swiftshader',
      ],
    });
    try {
      const page = await opened.newPage();
      await page.goto(pathToFileURL(EXAMPLE).href);
      const { height, speed, problems } = await page.evaluate(letFall);
      assert.ok(Math.abs(height - 0.5) < 0.01, `the box lies at ${height} m, not 0.5 m`);
      assert.ok(speed < 0.01, `and moves at ${speed} m/s`);
      assert.deepEqual(problems, []);
    } finally {
      await opened.close();
    }
  },
);
