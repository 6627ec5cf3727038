import fc from 'fast-check';
import { geometryTypes, type GeometryType } from '../../physics-core/shapes/geometry.js';
import type { Field } from '../../physics-core/nodes/node/table.js';
import { geometry } from './geometry.js';
import { nastyNumber, number, scale, turn, vector } from './numbers.js';

// Values for fields: tame ones are what an author could mean, nasty ones are what no author can.

/** Stands for a node of a scene: the one of these types that the number picks, once it is there. */
export interface Ref {
  ref: number;
  of: readonly string[];
}

export const isRef = (value: unknown): value is Ref =>
  typeof value === 'object' && value !== null && 'ref' in value;

const NASTY = [
  ...['', ' ', 'abc', '*', '1 2', '1,2,3', '0 0 0 0', 'NaN', '1e999', 'true', '__proto__'],
  ...[null, undefined, true, false, {}, [], [1], [NaN], [[1, 2], [3]], [null], [[[[[1]]]]]],
  ...[{ type: 'Nothing' }, { type: 'RigidBody' }, { type: 'Box', size: 'x' }, { length: -1 }],
  ...[new Float32Array(3), new Float64Array([1, NaN, 3]), new DataView(new ArrayBuffer(8))],
];

const nasty: fc.Arbitrary<unknown> = fc.oneof(
  nastyNumber,
  fc.constantFrom(...NASTY),
  ...[2, 3, 4, 9].map((length) =>
    fc.array(fc.oneof(nastyNumber, number(-2, 2)), { minLength: length, maxLength: length }),
  ),
);

const isGeometryType = (type: string): type is GeometryType =>
  (geometryTypes as readonly string[]).includes(type);

const inRange = ({ range }: Field): fc.Arbitrary<number> => {
  const [low, high] = range ?? [-3, 3];
  return number(Math.max(low, -5), Math.min(high, 5));
};

/** A node there is, one made for the place, or a geometry. */
function nodeFor(types: readonly string[], wild: boolean): fc.Arbitrary<unknown> {
  const shapes = types.filter(isGeometryType);
  if (shapes.length > 0) return geometry(wild, shapes);
  return fc.oneof(
    fc.record({ ref: fc.nat(9), of: fc.constant(types) }),
    ...(types.includes('CollidableShape') ? [geometry(wild)] : []),
  );
}

function tame(field: Field, wild: boolean): fc.Arbitrary<unknown> {
  const one = inRange(field);
  const two = fc.tuple(one, one);
  const { nodes = [], values, takesAll } = field;
  switch (field.type) {
    case 'SFBool':
      return fc.boolean();
    case 'SFFloat':
    case 'SFTime':
      return one;
    case 'SFInt32':
      return fc.integer({ min: 0, max: 60 });
    case 'SFString':
      return values ? fc.constantFrom(...values) : fc.constant('');
    case 'SFVec2f':
      return two;
    case 'SFVec3f':
      return fc.tuple(one, one, one);
    case 'SFRotation':
      return turn;
    case 'SFMatrix3f':
      return fc
        .tuple(scale(0.1, 10), scale(0.1, 10), scale(0.1, 10))
        .map(([x, y, z]) => [x, 0, 0, 0, y, 0, 0, 0, z]);
    case 'MFString':
      return fc.subarray([...TOKENS]);
    case 'MFVec3f':
      return fc.array(vector(5), { maxLength: 3 });
    case 'SFNode':
      return fc.oneof(fc.constant(null), nodeFor(nodes, wild));
    case 'MFNode':
      return fc.oneof(
        { weight: 4, arbitrary: fc.array(nodeFor(nodes, wild), { maxLength: 3 }) },
        ...(takesAll ? [{ weight: 2, arbitrary: fc.constant('*') }] : []),
      );
    default:
      return fc.array(one, { maxLength: 6 });
  }
}

const TOKENS = [
  ...['BOUNCE', 'FRICTION_COEFFICIENT-2', 'SLIP-1', 'SLIP-2', 'ERROR_REDUCTION'],
  ...['CONSTANT_FORCE', 'SPEED-1', 'SPEED-2', 'ALL', 'NONE'],
] as const;

/** A value for a field; of wild ones every third is nasty. */
export const valueOf = (field: Field, wild: boolean): fc.Arbitrary<unknown> =>
  wild
    ? fc.oneof({ weight: 2, arbitrary: tame(field, true) }, { weight: 1, arbitrary: nasty })
    : tame(field, false);
