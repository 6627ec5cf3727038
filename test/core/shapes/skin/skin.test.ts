import assert from 'node:assert/strict';
import { test } from 'node:test';
import { FacetSilhouette } from '../../../../physics-core/shapes/silhouette/facets.js';
import { silhouetteOf } from '../../../../physics-core/shapes/silhouette/of-outline.js';
import { skinOf } from '../../../../physics-core/shapes/skin/of-outline.js';
import type { Outline } from '../../../../physics-core/shapes/outline.js';
import { random } from '../../helpers.js';

/** As a share: what water does to it is made even by the exact silhouette. */
const NEAR = 0.02;

const SOLIDS: Record<string, Outline> = {
  'a box': { kind: 'box', half: [0.5, 1, 2] },
  'a ball': { kind: 'ball', radius: 0.7 },
  'a cylinder': { kind: 'frustum', bottom: 0.5, top: 0.5, half: 1 },
  'a cone': { kind: 'frustum', bottom: 0.5, top: 0, half: 0.6 },
};

for (const [name, outline] of Object.entries(SOLIDS))
  test(`the skin of ${name} shows nearly as much as it does, from wherever one looks`, () => {
    const next = random(5);
    const triangles = skinOf(outline);
    const skin = new FacetSilhouette(
      triangles,
      Array.from({ length: triangles.length / 3 }, (_, i) => i),
    );
    const exact = silhouetteOf(outline);
    for (let i = 0; i < 300; i++) {
      const way = Float64Array.from([next() - 0.5, next() - 0.5, next() - 0.5]);
      // Along axes, too.
      if (i < 9) (way.fill(0, 0, 1 + (i % 3)), (way[i % 3] = 1));
      const length = Math.hypot(...way);
      for (let k = 0; k < 3; k++) way[k] = way[k]! / length;
      const [one, other] = [new Float64Array(4), new Float64Array(4)];
      skin.along(way, one);
      exact.along(way, other);
      assert.ok(
        Math.abs(one[0]! / other[0]! - 1) < NEAR,
        `${one[0]} of ${other[0]} along ${way.join(' ')}`,
      );
    }
  });

test('the skin of a ball that is stretched shows nearly as much', () => {
  const outline: Outline = { kind: 'ellipsoid', squares: [1, 0.25, 2, 0.1, 0.2, -0.1] };
  const triangles = skinOf(outline);
  const skin = new FacetSilhouette(
    triangles,
    Array.from({ length: triangles.length / 3 }, (_, i) => i),
  );
  const exact = silhouetteOf(outline);
  for (const way of [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0.6, 0.8],
  ]) {
    const [one, other] = [new Float64Array(4), new Float64Array(4)];
    skin.along(Float64Array.from(way), one);
    exact.along(Float64Array.from(way), other);
    assert.ok(Math.abs(one[0]! / other[0]! - 1) < 0.03, `${one[0]} of ${other[0]}`);
  }
});
