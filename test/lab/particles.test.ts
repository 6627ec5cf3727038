import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { particlesPicture } from '../../lab/draw/particles-chart.js';
import { withCost, withParticles } from '../../lab/particles/draw.js';
import { formOf, forms } from '../../lab/particles/forms.js';
import { FOUNTAIN } from '../../lab/particles/fountain.js';
import { libraries } from '../../lab/particles/libraries.js';
import { missingIn } from '../../lab/particles/measure.js';
import { readParticles } from '../../lab/particles/numbers.js';
import { nodeScenes } from '../../lab/particles/scenes.js';

test('docs/particles-price.md, its picture and the costs in docs/particles.md are those of the numbers', () => {
  const numbers = readParticles();
  const text = readFileSync('docs/particles-price.md', 'utf8');
  assert.equal(withParticles(text, numbers), text);
  const guide = readFileSync('docs/particles.md', 'utf8');
  assert.equal(withCost(guide, numbers), guide);
  assert.equal(particlesPicture(numbers), readFileSync('docs/pictures/particles.svg', 'utf8'));
});

test('ten thousand particles are measured in every scene and form, by all who have it, in 15 turns at least', () => {
  const numbers = readParticles();
  const { count, turns, node, chromium } = numbers;
  assert.ok(count >= 10_000 && turns >= 15);
  assert.deepEqual(missingIn(numbers), []);
  assert.deepEqual(
    node.rows.map(({ scene }) => scene),
    nodeScenes.map(({ id }) => id),
  );
  assert.deepEqual(
    chromium.rows.map(({ form, sides }) => [form, Object.keys(sides)]),
    forms.map(({ id, sides }) => [id, sides]),
  );
});

/** One in a hundred: Babylon.js bears as many as the time of its frames makes whole ones. */
const FEW = 0.01;

test('as many live as the systems may have, in every library', () => {
  const { count, node, chromium } = readParticles();
  const least = (1 - FEW) * count;
  for (const { scene, living } of node.rows) assert.ok(living >= least, scene);
  for (const { form, sides } of chromium.rows.filter(({ form }) => !formOf(form).alone))
    for (const [side, cost] of Object.entries(sides))
      assert.ok(typeof cost !== 'string' && cost.living! >= least, `${form}, ${side}`);
});

/** Metres; the fountain is seven high. Cones are not filled alike, and Euler's rule leaves a step of gravity. */
const ALIKE = 0.5;

test('the fountains of ours and of Babylon.js are as high', () => {
  for (const { form, sides } of readParticles().chromium.rows) {
    const { ours, babylon } = sides;
    if (formOf(form).alone || !babylon || typeof ours === 'string' || typeof babylon === 'string')
      continue;
    assert.ok(Math.abs(ours!.height! - babylon.height!) < ALIKE, form);
  }
});

test('X3D’s two libraries are told the same fountain', () => {
  const { angle, speed, variation, size, life } = FOUNTAIN;
  for (const form of forms)
    for (const { id, page, file } of libraries.filter(
      (library) => library.id !== 'babylon' && form.sides.includes(library.id),
    )) {
      const text = (file ?? page)(form, 500, '');
      for (const words of [
        `geometryType="${form.geometryType}" particleSize="${size} ${size}" maxParticles="500" particleLifetime="${life}"`,
        `angle="${angle}" speed="${speed}" variation="${variation}"`,
      ])
        assert.ok(text.includes(words), `${form.id}, ${id}`);
      assert.equal(text.match(/<x3d-rigid-body /g)?.length ?? 0, form.bodies ?? 0);
    }
});
