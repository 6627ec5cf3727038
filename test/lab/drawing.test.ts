import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { drawingPicture } from '../../lab/draw/drawing-chart.js';
import { roomPicture } from '../../lab/draw/room-chart.js';
import { readDrawing } from '../../lab/drawing/numbers.js';
import { tablesOf } from '../../lab/drawing/text.js';

test('the pictures and tables of docs/drawing.md are those of the numbers beside it', () => {
  const numbers = readDrawing();
  const picture = (name: string): string => readFileSync(`docs/pictures/${name}.svg`, 'utf8');
  assert.equal(picture('drawing'), drawingPicture(numbers));
  assert.equal(picture('drawing-room'), roomPicture(numbers));
  const text = readFileSync('docs/drawing.md', 'utf8');
  for (const table of Object.values(tablesOf(numbers)))
    assert.ok(text.includes(`\n\n${table}\n\n`));
});

test('the drawing benchmark has three.js beside both ways, and the room at all its sizes', () => {
  const { rows, edits, room } = readDrawing();
  assert.deepEqual([...new Set(rows.map(({ bodies }) => bodies))], [100, 500, 1000, 2000, 5000]);
  for (const { plain, batched, three } of rows) {
    assert.ok(batched.calls <= 200);
    assert.ok(plain.calls > batched.calls && batched.calls > three.calls);
  }
  assert.deepEqual(
    edits.map(({ bodies }) => bodies),
    [50, 1000],
  );
  assert.deepEqual(
    room.map(({ boxes }) => boxes),
    [10, 50, 100, 200, 500, 1000],
  );
});
