import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { pagesPicture } from '../../lab/draw/pages-chart.js';
import { threadsPicture } from '../../lab/draw/threads-chart.js';
import { THINGS, withPages, withThreads } from '../../lab/page/draw.js';
import { libraries } from '../../lab/page/libraries/index.js';
import { readPages } from '../../lab/page/numbers.js';
import { boxes, links } from '../../lab/page/scene.js';
import { readThreads } from '../../lab/page/threads/numbers.js';

test('docs/pages.md and its pictures are drawn from the numbers of the report', () => {
  const numbers = readPages();
  const threads = readThreads();
  const text = readFileSync('docs/pages.md', 'utf8');
  assert.equal(withPages(text, numbers, threads), text);
  for (const [scene, things] of Object.entries(THINGS))
    assert.equal(
      pagesPicture(numbers, scene, things),
      readFileSync(`docs/pictures/pages-${scene}.svg`, 'utf8'),
    );
  const guide = readFileSync('site/guide/thread.md', 'utf8');
  assert.equal(withThreads(guide, threads), guide);
  assert.equal(threadsPicture(threads), readFileSync('docs/pictures/pages-threads.svg', 'utf8'));
});

test('what is compared in pages stands on at least 15 pairs, and intervals hold their medians', () => {
  const { turns, browsers } = readPages();
  assert.ok(turns >= 15);
  for (const { cells } of Object.values(browsers))
    for (const { scene, count, script } of cells)
      for (const [side, cost] of Object.entries(script)) {
        if (typeof cost === 'string') continue;
        for (const { low, median, high } of [cost.script, cost.physics, cost.drawing])
          assert.ok(low <= median && median <= high, `${count} ${scene}, ${side}`);
      }
});

test('what a page pays for either thread stands on a hundred frames at least, and edits were seen', () => {
  const { frames, browsers } = readThreads();
  assert.ok(frames >= 100);
  for (const { count, ratio, main, worker } of Object.values(browsers).flatMap((one) => one.cells))
    for (const side of [main, worker]) {
      assert.ok(ratio.low <= ratio.median && ratio.median <= ratio.high, `${count} boxes`);
      for (const { low, median, high, most } of [side.own, side.drawing])
        assert.ok(low <= median && median <= high && median <= most, `${count} boxes`);
      assert.ok(side.kept > 0 && side.kept <= 1, `${count} boxes`);
      assert.ok(side.steady.edits > 0 && side.late.edits > 0, `${count} boxes`);
    }
});

test('from a hundred boxes on a worker takes most of our script off the page’s own thread', () => {
  for (const { count, ratio } of Object.values(readThreads().browsers).flatMap((one) => one.cells))
    if (count >= 100) assert.ok(ratio.high < 0.5, `${count} boxes: ${ratio.high}`);
});

/** Milliseconds: a frame and a step of `standard`, and what a body sent up in single precision is off by. */
const FRAME_AND_STEP = 1000 / 60 + 1000 / 120 + 0.01;

test('an edit is seen a frame later where a worker keeps up, at most a frame and a step behind', () => {
  for (const { count, main, worker } of Object.values(readThreads().browsers).flatMap(
    (one) => one.cells,
  )) {
    assert.equal(main.steady.frame.median, 1, `${count} boxes`);
    assert.equal(worker.steady.frame.median, 2, `${count} boxes`);
    assert.ok(
      worker.steady.behind.median <= FRAME_AND_STEP,
      `${count} boxes: ${worker.steady.behind.median} ms`,
    );
  }
});

test('every library gets all things and all joints of a scene', () => {
  const count = (text: string, word: RegExp): number => text.match(word)?.length ?? 0;
  const bodies: Record<string, RegExp> = {
    ours: /<x3d-rigid-body /g,
    'x-ite': /<RigidBody DEF=/g,
    'a-frame': / ammo-body="/g,
    ammo: /"mass":/g,
  };
  const joints: Record<string, RegExp> = {
    ours: /<x3d-single-axis-hinge-joint /g,
    'x-ite': /<SingleAxisHingeJoint /g,
    'a-frame': / ammo-constraint="/g,
    ammo: /"anchor":/g,
  };
  const room = boxes(20);
  const chain = links(20);
  assert.equal(chain.hinges.length, 20);
  for (const { id, page, file } of libraries) {
    const kind = id.startsWith('ours') ? 'ours' : id;
    const [boxPage, linkPage] = [room, chain].map((scene) => (file ?? page)(scene, ''));
    assert.equal(count(boxPage!, bodies[kind]!), 20 + 1 + 5, id);
    // Ammo's page names the two bodies of each joint in full.
    if (kind !== 'ammo') assert.equal(count(linkPage!, bodies[kind]!), 22, id);
    assert.equal(count(linkPage!, joints[kind]!), 20, id);
  }
});
