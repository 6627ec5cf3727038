import assert from 'node:assert/strict';
import { ConvexContact } from '../../../../physics-core/effects/manifolds/convex-contact.js';
import { FoundPoints } from '../../../../physics-core/effects/manifolds/found-points.js';
import { NearestPoints } from '../../../../physics-core/effects/manifolds/nearest-points.js';
import { PlacedForm } from '../../../../physics-core/effects/manifolds/placed-form.js';
import { SeparatingAxes } from '../../../../physics-core/effects/manifolds/separating-axes.js';
import { writeMatrix } from '../../../../physics-core/base/matrix.js';
import { BoxForm } from '../../../../physics-core/shapes/forms/box.js';
import { FrustumForm } from '../../../../physics-core/shapes/forms/frustum.js';
import { above, fact, random } from '../../helpers.js';

const FORMS = [new BoxForm([0.5, 0.3, 0.2]), new FrustumForm(0.4, 0.1, 0.3)];
const LEVEL = Float64Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1);
/** Metres, as Bullet has it for what is about a metre wide. */
const LIMIT = 0.02;

function place(r: () => number, reach: number): PlacedForm {
  const q = [r() - 0.5, r() - 0.5, r() - 0.5, r() - 0.5];
  const size = Math.hypot(...q);
  const rows = Float64Array.from(LEVEL);
  writeMatrix(
    rows,
    0,
    q.map((x) => x / size),
    0,
  );
  const placed = new PlacedForm();
  placed.form = FORMS[Math.floor(FORMS.length * r())]!;
  const at = Float64Array.from({ length: 3 }, () => reach * (2 * r() - 1));
  placed.put(rows, at, LEVEL, new Float64Array(3));
  return placed;
}

const unknown = (a: PlacedForm, b: PlacedForm): Float64Array => {
  const between = a.origin.map((x, k) => x - b.origin[k]!);
  const size = Math.hypot(...between);
  return between.map((x) => x / size);
};

fact('what is no contact names a direction that separates it, and what is one has none', () => {
  const r = random(5);
  const contact = new ConvexContact();
  const axes = new SeparatingAxes();
  const points = new FoundPoints();
  const count = { apart: 0, touching: 0 };
  for (let pair = 1; pair <= 3000; pair++) {
    const a = place(r, 0.5);
    const b = place(r, 0.5);
    const normal = unknown(a, b);
    points.clear();
    contact.find(a, b, normal, LIMIT, points);
    axes.note(pair, normal);
    const apart = axes.separates(pair, a, b, LIMIT);
    assert.equal(apart, points.count === 0, `pair ${pair}`);
    count[apart ? 'apart' : 'touching']++;
  }
  above(Math.min(count.apart, count.touching), 500);
});

fact(
  'what moves on beside each other is searched again only when the old direction no longer separates it',
  () => {
    const r = random(9);
    const contact = new ConvexContact();
    const axes = new SeparatingAxes();
    const points = new FoundPoints();
    let searches = 0;
    const { find } = NearestPoints.prototype;
    NearestPoints.prototype.find = function (...given) {
      searches++;
      return find.apply(this, given);
    };
    try {
      const b = place(r, 0);
      const a = place(r, 0);
      for (let step = 0; step < 100; step++) {
        a.origin.set([0.62 + 1e-4 * step, 0.55, 0.3]);
        if (axes.separates(1, a, b, LIMIT)) continue;
        const normal = unknown(a, b);
        points.clear();
        contact.find(a, b, normal, LIMIT, points);
        axes.note(1, normal);
      }
    } finally {
      NearestPoints.prototype.find = find;
    }
    assert.ok(searches <= 1, `${searches} searches`);
  },
);

fact('of a pair that was never looked at nothing is known', () => {
  const r = random(3);
  assert.equal(new SeparatingAxes().separates(7, place(r, 5), place(r, 5), LIMIT), false);
});
