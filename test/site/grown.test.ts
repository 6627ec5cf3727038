import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { grown } from '../../site/gather/grown.js';

const page = (name: string): string => grown(name, readFileSync(`stories/pages/${name}`, 'utf8'));
const scene = (name: string): string => /<scene>[^]*<\/scene>/i.exec(page(name))![0];
const count = (text: string, pattern: RegExp): number => text.match(pattern)?.length ?? 0;

test('scenes that a script lets grow stand in the playground with what grew, in both spellings', () => {
  for (const ending of ['html', 'xhtml']) {
    const room = scene(`room-of-boxes.${ending}`);
    // The room itself and its ball.
    assert.equal(count(room, /<(x3d-rigid-body|RigidBody)\b/g), 48 + 7);
    const chain = scene(`growing-chain.${ending}`);
    assert.equal(count(chain, /<(x3d-single-axis-hinge-joint|SingleAxisHingeJoint)\b/g), 40);
    for (let i = 1; i <= 40; i++) assert.ok(chain.includes(`id="link${i}"`), `link${i}`);
  }
});

test('no two boxes of the room begin in each other', () => {
  const room = scene('room-of-boxes.html');
  const boxes = [
    ...room.matchAll(
      /translation="([^"]+)">\s*<shape>\s*<appearance><material diff[^]*?<box size="([\d.]+) /g,
    ),
  ].map(([, at, size]) => ({ at: at!.split(' ').map(Number), size: Number(size) }));
  assert.equal(boxes.length, 48);
  for (const [i, a] of boxes.entries())
    for (const b of boxes.slice(i + 1)) {
      const apart = Math.max(...a.at.map((value, axis) => Math.abs(value - b.at[axis]!)));
      assert.ok(apart > (a.size + b.size) / 2);
    }
});

test('a page that does not grow stays as it is', () => {
  const text = readFileSync('stories/pages/pendulum.html', 'utf8');
  assert.equal(grown('pendulum.html', text), text);
});
