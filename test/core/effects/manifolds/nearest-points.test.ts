import { writeMatrix } from '../../../../physics-core/base/matrix.js';
import { NearestPoints } from '../../../../physics-core/effects/manifolds/nearest-points.js';
import { PlacedForm } from '../../../../physics-core/effects/manifolds/placed-form.js';
import { FrustumForm } from '../../../../physics-core/shapes/forms/frustum.js';
import { above, below, fact, random, type Vec3 } from '../../helpers.js';

// Where rims meet, the search comes to corners that are nearly one, and from there on only rounding is left: what it found
// before must stand.

const HALF = 0.2;
const CYLINDER = new FrustumForm(0.2, 0.2, HALF);
const LEVEL = Float64Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1);

/** By how much they overlap, metres. */
const OVERLAP = 1e-5;

/** What single precision, in which bodies are placed, has at a metre. */
const ROUNDING = 1e-7;

function turned(r: () => number): Float64Array {
  const q = [r() - 0.5, r() - 0.5, r() - 0.5, r() - 0.5];
  const size = Math.hypot(...q);
  const rows = Float64Array.from(LEVEL);
  writeMatrix(
    rows,
    0,
    q.map((x) => x / size),
    0,
  );
  return rows;
}

function place(r: () => number): PlacedForm {
  const placed = new PlacedForm();
  placed.form = CYLINDER;
  placed.put(turned(r), new Float64Array(3), LEVEL, new Float64Array(3));
  return placed;
}

const unit = (v: number[]): Vec3 => v.map((x) => x / Math.hypot(...v)) as Vec3;
const axisOf = ({ turn }: PlacedForm): Vec3 => [turn[1]!, turn[4]!, turn[7]!];
const cross = ([a, b, c]: Vec3, [x, y, z]: Vec3) => [b * z - c * y, c * x - a * z, a * y - b * x];

/** Of what is farthest along `n`: a point of the rim, or, `onSide`, any of the straight line. */
function farthest(form: PlacedForm, n: Vec3, onSide: boolean, r: () => number): number[] {
  const out = new Float64Array(3);
  form.support(Float64Array.from(n), 1, out, 0);
  if (!onSide) return [...out];
  const axis = axisOf(form);
  const on = 2 * HALF * (r() - 0.5) - axis.reduce((sum, a, k) => sum + a * out[k]!, 0);
  return axis.map((a, k) => out[k]! + a * on);
}

type Towards = (a: PlacedForm, b: PlacedForm, any: Vec3) => number[];

const MEETINGS: [string, Towards, boolean, boolean][] = [
  ['rim on rim', (_a, _b, any) => any, false, false],
  ['rim on side', (_a, b, any) => cross(axisOf(b), any), false, true],
  ['side on side', (a, b) => cross(axisOf(a), axisOf(b)), true, true],
];

for (const [says, towards, sideOfA, sideOfB] of MEETINGS)
  fact(`two cylinders that hardly overlap, ${says}, are found to overlap by no more`, () => {
    const r = random(3);
    const nearest = new NearestPoints();
    for (let i = 0; i < 1000; i++) {
      const [a, b] = [place(r), place(r)];
      const any = unit([r() - 0.5, r() - 0.5, r() - 0.5]);
      const n = unit(towards(a, b, any));
      const [onA, onB] = [
        farthest(a, n.map((x) => -x) as Vec3, sideOfA, r),
        farthest(b, n, sideOfB, r),
      ];
      n.forEach((x, k) => (a.origin[k] = onB[k]! - onA[k]! - OVERLAP * x));
      nearest.normal.set(unit(n.map((x) => x + 0.02 * (r() - 0.5))));
      nearest.find(a, b);
      // Along n they overlap by so much; another direction may take less.
      above(nearest.distance, -OVERLAP - ROUNDING, `pair ${i}`);
      below(nearest.distance, ROUNDING, `pair ${i}`);
    }
  });
