import { expect } from 'chai';
import {
  AFFINE,
  multiplyInto,
  putAffine,
  putNormals,
  putProjected,
  read,
  unread,
} from '../../../../elements/bridge/batch/products.js';
import { x3dom, type X3DMatrix } from '../../../../elements/bridge/x3dom/x3dom.js';
import '../../console.js';

interface Matrix extends X3DMatrix {
  inverse(): Matrix;
  transpose(): Matrix;
  toGL(): number[];
}
type Fields = Record<'SFMatrix4f', new (...numbers: number[]) => Matrix>;
const { SFMatrix4f } = x3dom()!.fields as unknown as Fields;

/** From -10 to 10, the same in every run. */
function* numbers(seed: number): Generator<number, never> {
  for (let state = seed; ;) {
    state = (state * 16807) % 2147483647;
    yield (20 * state) / 2147483647 - 10;
  }
}
const random = numbers(11);
const some = (count: number): number[] => Array.from({ length: count }, () => random.next().value);

const matrixOf = (...rows: number[]): Matrix => new SFMatrix4f(...rows);
const affine = (): Matrix => matrixOf(...some(AFFINE), 0, 0, 0, 1);

/** x3dom's cameras are inverses: their last number is one but for rounding. */
function scene(): Record<'body' | 'view' | 'camera', Matrix> {
  const view = affine().inverse();
  return { body: affine(), view, camera: matrixOf(...some(16)).mult(view) as Matrix };
}

function rowsOf(matrix: Matrix): Float64Array {
  const rows = unread();
  read(matrix, rows);
  return rows;
}

/** A picture does not tell 0 from -0. */
const withoutSigns = (values: Iterable<number>): number[] => [...values].map((value) => value + 0);

/** As WebGL takes them from x3dom: in single precision, so many rows of four columns. */
const columns = (matrix: X3DMatrix, rows: number): number[] =>
  withoutSigns((matrix as Matrix).toGL().filter((_, i) => i % 4 < rows)).map(Math.fround);

/** Three columns, of each what is beside it left out. */
const inColumns = (out: Float32Array): number[] =>
  withoutSigns(out.slice(0, 12).filter((_, i) => i % 4 < 3));

describe('what a body drawn with others is handed over with', () => {
  it('is what x3dom hands over for it, to the last bit: 200 at random', () => {
    const out = new Float32Array(16);
    const seen = new Float64Array(AFFINE);
    for (let i = 0; i < 200; i++) {
      const { body, view, camera } = scene();
      putProjected(rowsOf(camera), rowsOf(body), 0, out, 0);
      expect(withoutSigns(out)).to.eql(columns(camera.mult(body), 4));

      multiplyInto(rowsOf(view), rowsOf(body), 0, seen);
      putAffine(seen, 0, out, 0);
      const eye = columns(view.mult(body), 3);
      expect([...inColumns(out), ...withoutSigns([out[3]!, out[7]!, out[11]!])]).to.eql(eye);

      putNormals(seen, view._33, out, 0);
      const normals = (view.mult(body) as Matrix).inverse().transpose();
      expect(inColumns(out)).to.eql(columns(normals, 3).slice(0, 9));
    }
  });

  it('of no size has the normals that x3dom takes where there is no inverse', () => {
    const out = new Float32Array(12);
    putNormals(new Float64Array(AFFINE), 1, out, 0);
    expect(inColumns(out)).to.eql([1, 0, 0, 0, 1, 0, 0, 0, 1]);
  });

  it('is worked out anew where a matrix has another number', () => {
    const matrix = matrixOf(...some(16));
    const out = unread();
    expect([read(matrix, out), read(matrix, out)]).to.eql([true, false]);
    matrix._21 *= 1 + Number.EPSILON;
    expect(read(matrix, out)).to.equal(true);
  });
});
