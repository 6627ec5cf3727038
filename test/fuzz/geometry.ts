import fc from 'fast-check';
import {
  geometryFields,
  geometryTypes,
  type GeometryType,
} from '../../physics-core/shapes/geometry.js';
import { nastyNumber, number, scale, turn, vector } from './numbers.js';

// Every X3D geometry, of some size between a finger and a car.

const length = scale(0.05, 3);
const count = fc.integer({ min: 0, max: 8 });
const points = fc.array(number(-1, 1), { maxLength: 36 });
const indices = fc.array(fc.integer({ min: -1, max: 11 }), { maxLength: 24 });

/** A solid with faces in order, so that meshes are not always broken ones. */
const TETRAHEDRON = {
  coord: [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1],
  index: [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3],
  coordIndex: [0, 2, 1, -1, 0, 1, 3, -1, 0, 3, 2, -1, 1, 2, 3, -1],
};

/** Two tetrahedra on one edge: no hull. */
const BUTTERFLY = {
  coord: [0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 0, 1, -1, 0, 0, -1, 0, 1],
  index: [0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2, 0, 4, 1, 0, 1, 5, 0, 5, 4, 1, 4, 5],
  coordIndex: [0, 1, 2, -1, 0, 3, 1, -1, 0, 2, 3, -1, 1, 3, 2, -1, 0, 4, 1, -1, 0, 1, 5, -1],
};

const faces = fc.oneof(
  fc.constantFrom<Record<string, unknown>>(TETRAHEDRON, BUTTERFLY),
  fc.record<Record<string, unknown>>({ coord: points, index: indices, coordIndex: indices }),
);

const counts = fc.array(count, { maxLength: 3 });

const grid = fc.integer({ min: 0, max: 5 }).chain((xDimension) =>
  fc.record<Record<string, unknown>>({
    xDimension: fc.constant(xDimension),
    zDimension: fc.constant(xDimension),
    xSpacing: scale(0.2, 2),
    zSpacing: scale(0.2, 2),
    height: fc.array(number(-0.5, 0.5), {
      minLength: xDimension ** 2,
      maxLength: xDimension ** 2,
    }),
  }),
);

/** Values that make sense for each field, whatever geometry it is of. */
const OF_FIELD: Record<string, fc.Arbitrary<unknown>> = {
  radius: length,
  height: length,
  bottomRadius: length,
  topRadius: length,
  innerRadius: scale(0.05, 0.5),
  outerRadius: scale(0.5, 2),
  side: fc.boolean(),
  top: fc.boolean(),
  bottom: fc.boolean(),
  ccw: fc.boolean(),
  stripCount: counts,
  fanCount: counts,
};

function shapeOf(type: GeometryType): fc.Arbitrary<Record<string, unknown>> {
  if (type === 'ElevationGrid') return grid;
  if (type === 'Box') return fc.record({ size: fc.tuple(length, length, length) });
  if (type === 'Rectangle2D') return fc.record({ size: fc.tuple(length, length) });
  if (type === 'Mesh') return faces.map(({ coord, index }) => ({ points: coord, index }));
  const names = Object.keys(geometryFields(type));
  const own = names.filter((name) => name in OF_FIELD);
  const fields = fc.record(Object.fromEntries(own.map((name) => [name, OF_FIELD[name]!])));
  return names.includes('coord')
    ? fc.tuple(faces, fields).map(([mesh, rest]) => ({ ...mesh, ...rest }))
    : fields;
}

const placement = fc.record(
  { translation: vector(1), rotation: turn, linear: fc.constant([1, 0, 0, 0, 2, 0, 0, 0, 0.5]) },
  { requiredKeys: [] },
);

/** What is simple comes up more often. */
const COMMON: readonly GeometryType[] = ['Box', 'Sphere', 'Cylinder', 'IndexedFaceSet'];

export function geometry(
  wild: boolean,
  types: readonly GeometryType[] = geometryTypes,
): fc.Arbitrary<Record<string, unknown>> {
  const common = COMMON.filter((type) => types.includes(type));
  const often = common.length > 0 ? common : types;
  const type = fc.oneof(fc.constantFrom(...types), fc.constantFrom(...often));
  return type.chain((chosen) => {
    const sound = fc
      .tuple(shapeOf(chosen), fc.option(placement, { freq: 4, nil: {} }))
      .map(([shape, placed]) => ({ type: chosen, ...shape, ...placed }));
    if (!wild) return sound;
    const names = Object.keys(geometryFields(chosen));
    return fc
      .tuple(sound, fc.option(fc.tuple(fc.constantFrom(...names), broken), { freq: 3 }))
      .map(([whole, fault]) => (fault ? { ...whole, [fault[0]]: fault[1] } : whole));
  });
}

const broken: fc.Arbitrary<unknown> = fc.oneof(
  nastyNumber,
  fc.array(nastyNumber, { maxLength: 9 }),
  fc.constantFrom<unknown>(null, '', 'x', {}, [[]], { point: null }, { point: [1, 2] }),
);
