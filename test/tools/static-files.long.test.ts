import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { get } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
// @ts-expect-error plain JavaScript
import { findFile, serve } from '../../tools/docs/static-files.js';

const folder = mkdtempSync(join(tmpdir(), 'x3d-physics-static-'));
after(() => rmSync(folder, { recursive: true }));
writeFileSync(join(folder, 'index.html'), '<!doctype html>');
writeFileSync(join(folder, 'motor.x3d'), '<X3D/>');
writeFileSync(join(folder, 'page.xhtml'), '<html xmlns="http://www.w3.org/1999/xhtml"/>');

/** `fetch` would mend the path. */
const answer = (port: number, path: string): Promise<string> =>
  new Promise((resolve, reject) => {
    get({ host: 'localhost', port, path }, (response) => {
      response.resume();
      resolve(`${response.statusCode} ${response.headers['content-type']}`);
    }).on('error', reject);
  });

test('the server of npm start outlives addresses that are none, and names the types of x3d files', async () => {
  const { port, close } = await serve(folder, 8300);
  try {
    for (const path of ['/%E0%A4%A', '/%', '/nothing.html', '/../package.json', '/%2e%2e/x'])
      assert.match(await answer(port, path), /^40\d/, path);
    assert.match(await answer(port, '/'), /^200 text\/html/);
    assert.match(await answer(port, '/motor.x3d'), /^200 model\/x3d\+xml/);
    assert.match(await answer(port, '/page.xhtml'), /^200 application\/xhtml\+xml/);
    const second = await serve(folder, port);
    assert.notEqual(second.port, port);
    await second.close();
  } finally {
    await close();
  }
});

test('pages that are no files are served beside those that are', async () => {
  const { port, close } = await serve(folder, 8310, { '/made.html': '<title>made</title>' });
  try {
    const made = await fetch(`http://localhost:${port}/made.html`);
    assert.match(made.headers.get('content-type')!, /^text\/html/);
    assert.equal(await made.text(), '<title>made</title>');
    assert.match(await answer(port, '/motor.x3d'), /^200 /);
    assert.match(await answer(port, '/toString'), /^404/);
  } finally {
    await close();
  }
});

test('nor does the server of the tests find a file by such an address', () => {
  for (const path of ['/%E0%A4%A', '/%', '/../package.json'])
    assert.equal(findFile(folder, path), undefined, path);
  assert.equal(findFile(folder, '/page.xhtml').type, 'application/xhtml+xml; charset=utf-8');
});
