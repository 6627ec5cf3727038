import assert from 'node:assert/strict';
import { test } from 'node:test';
import { labelsOf, type Label } from '../../../../elements/ui/chart/labels.js';
import { random } from '../../../core/helpers.js';

const LEVELS = ['game', 'standard', 'fine', 'precise', 'reference'];

/** Pixels: of a letter at most, of a line. */
const LETTER = 6.5;
const LINE = 11;
/** Of the halo around the letters, as Firefox counts it, pixels. */
const HALO = 2.5;

const ends = ({ text, x, anchor }: Label): [number, number] => {
  const width = LETTER * text.length;
  const [left, right] = anchor === 'start' ? [x, x + width] : [x - width, x];
  return [left - HALO, right + HALO];
};

const hide = (a: Label, b: Label): boolean => {
  const [[left, right], [first, last]] = [ends(a), ends(b)];
  return Math.abs(a.y - b.y) < LINE && left < last && first < right;
};

test('no name of the chart hides another one, however close the dots are', () => {
  const next = random(7);
  const within = { left: 80, right: 320, top: 28, bottom: 228 };
  const clamp = (value: number, from: number, to: number): number =>
    Math.max(from, Math.min(to, value));
  for (let drawing = 0; drawing < 5000; drawing++) {
    const [x, y] = [80 + 240 * next(), 28 + 200 * next()];
    const [wide, high] = [next() < 0.5 ? 10 : 240, next() < 0.5 ? 3 : 200];
    const dots = LEVELS.map((name) => ({
      name,
      x: clamp(x + (next() - 0.5) * wide, within.left, within.right),
      y: clamp(y + (next() - 0.5) * high, within.top, within.bottom),
    }));
    const labels = labelsOf(dots, within);
    for (const [i, label] of labels.entries()) {
      const others = labels.slice(i + 1);
      assert.ok(!others.some((other) => hide(label, other)), JSON.stringify(dots));
      assert.ok(label.y > LINE && ends(label)[0] >= 0 && ends(label)[1] <= 336);
    }
  }
});
