import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { pagesPicture } from '../../lab/draw/pages-chart.js';
import { THINGS, withPages } from '../../lab/page/draw.js';
import { libraries } from '../../lab/page/libraries/index.js';
import { readPages } from '../../lab/page/numbers.js';
import { boxes, links } from '../../lab/page/scene.js';

test('docs/pages.md and its pictures are drawn from the numbers of the report', () => {
  const numbers = readPages();
  const text = readFileSync('docs/pages.md', 'utf8');
  assert.equal(withPages(text, numbers), text);
  for (const [scene, things] of Object.entries(THINGS))
    assert.equal(
      pagesPicture(numbers, scene, things),
      readFileSync(`docs/pictures/pages-${scene}.svg`, 'utf8'),
    );
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
