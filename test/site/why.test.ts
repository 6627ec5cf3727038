import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

test('figures of "why this, and when not" are those of the pages that it links to', () => {
  const why = readFileSync('site/guide/why.md', 'utf8');
  const stability = readFileSync('docs/stability.md', 'utf8');
  const price = readFileSync('docs/price.md', 'utf8').split('### `standard`')[1]!;
  const [, ours, jolt, rapier, ammo, xIte, cannon] =
    /\n\| (\d+) \| (\d+) \| (\d+) \| (\d+) \| (\d+) \| (\d+) \|\n/.exec(why)!;
  const told = `raw Ammo ${ammo}, X_ITE's rule ${xIte}, Jolt ${jolt}, Rapier ${rapier}, cannon-es ${cannon}`;
  assert.ok(stability.includes(told), told);
  assert.ok(stability.includes(`, ${ours} hold here at`), ours);
  const costs = [...why.matchAll(/^\| ([^|]+) \| ([\d.]+) \| ([\d.]+) \| ([\d.]+) \|$/gm)];
  assert.equal(costs.length, 5);
  for (const [, scene, ...medians] of costs) {
    const row = price.split('\n').find((line) => line.startsWith(`| ${scene} |`))!;
    const [, , , mine, , theirs, others] = row.split('|').map((cell) => cell.trim().split(' ')[0]);
    assert.deepEqual([mine, theirs, others], medians, scene);
  }
});
