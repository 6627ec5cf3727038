// The chunk `shapes`: node types for x3dom, of geometry that collides and that it lacks.
import { meshes, type Geometry } from '../../../../physics-core/inside.js';
import type { NodeContext, X3DNode, X3DNodeClass, X3DOM } from '../x3dom.js';
import { extrude } from './extrude.js';
import type { Shapes } from './shapes.js';
import { normalsOf, type Surface } from './surface.js';

export const provide = (): Shapes => ({ register });

type Fields = Record<string, never>;
type FieldRow = [type: string, name: string, ...defaults: unknown[]];

/** One geometry: its fields by x3dom's types, and its triangles by their values. */
interface ShapeRow {
  fields: FieldRow[];
  surface(values: Fields, coord: number[]): Surface;
  /** Where faces meet at less, they are smooth, radians. */
  crease(values: Fields): number;
}

interface Point {
  x: number;
  y: number;
  z: number;
  w: number;
}

const triangles = (geometry: Geometry): Surface => meshes.code.tessellate(geometry);

const faces = (points: number[], polygon: number[]): number[] =>
  triangles({ type: 'IndexedFaceSet', coord: points, coordIndex: [...polygon, -1] }).index;

/** Smooth or flat, as x3dom has it for sets without a crease angle. */
const smooth = ({ normalPerVertex }: Fields): number => (normalPerVertex ? Math.PI : 0);
const creased = ({ creaseAngle }: Fields): number => creaseAngle;

/** Sets of triangles of which x3dom has others. */
const set = (type: 'QuadSet', name?: string): ShapeRow => ({
  fields: name ? [['MFInt32', name, []]] : [],
  surface: (values, coord) => {
    const lists = name ? { [name]: Array.from(values[name] as number[]) } : {};
    const surface = triangles({ type, coord, ...lists });
    const faces = /Quad/.test(type) ? surface.index.map((_, i) => Math.floor(i / 6)) : undefined;
    return { ...surface, faces: faces?.filter((_, i) => i % 3 === 0) };
  },
  crease: smooth,
});
const setOf = (type: string, name?: string): ShapeRow => set(type as 'QuadSet', name);

const flatTexCoords = (points: number[]): number[] => {
  const [x, y] = [0, 1].map((axis) => points.filter((_, i) => i % 3 === axis));
  const [left, low] = [Math.min(...x), Math.min(...y)];
  const [width, height] = [Math.max(...x) - left || 1, Math.max(...y) - low || 1];
  return x.flatMap((value, i) => [(value - left) / width, (y[i] - low) / height]);
};

const flat = (geometry: Geometry): Surface => {
  const surface = triangles(geometry);
  return { ...surface, texCoords: flatTexCoords(surface.points) };
};

function grid(values: Fields): Surface {
  const { xDimension: x, zDimension: z, xSpacing, zSpacing, height } = values;
  const heights = Array.from(height as number[]);
  const at = { xDimension: x, zDimension: z, xSpacing, zSpacing, height: heights };
  const { points, index } = triangles({ type: 'ElevationGrid', ...at });
  const texCoords = points.flatMap((_, i) => {
    if (i % 3 !== 0) return [];
    const column = (i / 3) % x;
    return [column / Math.max(1, x - 1), (i / 3 - column) / x / Math.max(1, z - 1)];
  });
  return { points, index, faces: index.map((_, i) => Math.floor(i / 2)), texCoords };
}

const list = (value: unknown): Point[] => Array.from(value as Iterable<Point>);
const SQUARE = [1, 1, 1, -1, -1, -1, -1, 1, 1, 1];

function extrusion(values: Fields): Surface {
  const section = list(values.crossSection).map(({ x, y }): [number, number] => [x, y]);
  const spine = list(values.spine).map(({ x, y, z }): [number, number, number] => [x, y, z]);
  const square = SQUARE.flatMap((x, i) => (i % 2 ? [] : [[x, SQUARE[i + 1]]]));
  return extrude(
    {
      crossSection: section.length > 0 ? section : (square as [number, number][]),
      spine: spine.length > 0 ? spine : [[0, 0, 0], [0, 1, 0]], // prettier-ignore
      scale: list(values.scale).map(({ x, y }) => [x, y]),
      orientation: list(values.orientation).map(({ x, y, z, w }) => [x, y, z, w]),
      beginCap: values.beginCap,
      endCap: values.endCap,
    },
    faces,
  );
}

const SHAPES: Record<string, ShapeRow> = {
  ElevationGrid: {
    fields: [
      ['SFInt32', 'xDimension', 0],
      ['SFInt32', 'zDimension', 0],
      ['SFFloat', 'xSpacing', 1],
      ['SFFloat', 'zSpacing', 1],
      ['MFFloat', 'height', []],
      ['SFFloat', 'creaseAngle', 0],
    ],
    surface: grid,
    crease: creased,
  },
  Extrusion: {
    fields: [
      ['MFVec2f', 'crossSection', []],
      ['MFVec3f', 'spine', []],
      ['MFVec2f', 'scale', []],
      ['MFRotation', 'orientation', []],
      ['SFBool', 'beginCap', true],
      ['SFBool', 'endCap', true],
      ['SFBool', 'convex', true],
      ['SFFloat', 'creaseAngle', 0],
    ],
    surface: extrusion,
    crease: creased,
  },
  TriangleFanSet: setOf('TriangleFanSet', 'fanCount'),
  TriangleStripSet: setOf('TriangleStripSet', 'stripCount'),
  QuadSet: setOf('QuadSet'),
  IndexedTriangleFanSet: setOf('IndexedTriangleFanSet', 'index'),
  IndexedTriangleStripSet: setOf('IndexedTriangleStripSet', 'index'),
  IndexedQuadSet: setOf('IndexedQuadSet', 'index'),
  Rectangle2D: {
    fields: [['SFVec2f', 'size', 2, 2]],
    surface: ({ size }) =>
      flat({ type: 'Rectangle2D', size: [(size as Point).x, (size as Point).y] }),
    crease: () => 0,
  },
  Disk2D: {
    fields: [
      ['SFFloat', 'innerRadius', 0],
      ['SFFloat', 'outerRadius', 1],
    ],
    surface: ({ innerRadius, outerRadius }) => flat({ type: 'Disk2D', innerRadius, outerRadius }),
    crease: () => 0,
  },
};

function register(x: X3DOM): void {
  for (const [name, row] of Object.entries(SHAPES)) {
    if (x.nodeTypesLC[name.toLowerCase()]) continue;
    x.registerNodeType(name, 'Geometry3D', makeType(row, x));
  }
}

/** What x3dom's geometry has that is filled here. */
interface GeometryNode extends X3DNode {
  _mesh: X3DNode['_mesh'] & {
    _normals: number[][];
    _texCoords: number[][];
    _colors: number[][];
    _numColComponents: number;
    _numFaces: number;
    _numCoords: number;
  };
}

interface Look {
  normals?: Point[] | undefined;
  colors?: Record<string, number>[] | undefined;
  texCoords?: Point[] | undefined;
}

const childValues = <T>(node: X3DNode, role: string, field: string): T[] | undefined => {
  const value = node._cf[role]?.node?._vf[field] as Iterable<T> | undefined;
  return value && Array.from(value);
};

function makeType(row: ShapeRow, x: X3DOM): X3DNodeClass {
  return class extends x.nodeTypes.X3DComposedGeometryNode {
    /** The triangles that collide: as they face. */
    surface: Surface = { points: [], index: [] };

    constructor(context: NodeContext) {
      super(context);
      const adders = this as unknown as Record<string, (...args: unknown[]) => void>;
      for (const [type, name, ...defaults] of row.fields)
        adders[`addField_${type}`](context, name, ...defaults);
    }

    override nodeChanged(): void {
      const values = this._vf as Fields;
      const points = childValues<Point>(this, 'coord', 'point') ?? [];
      const coord = points.flatMap(({ x: a, y: b, z: c }) => [a, b, c]);
      const surface = row.surface(values, coord);
      const { points: at, index } = surface;
      this.surface = { points: at, index: values.ccw ? index : index.toReversed() };
      fill(this as unknown as GeometryNode, surface, row.crease(values), {
        normals: childValues<Point>(this, 'normal', 'vector'),
        colors: childValues(this, 'color', 'color'),
        texCoords: childValues<Point>(this, 'texCoord', 'point'),
      });
      this.invalidateVolume();
      for (const shape of this._parentNodes as (X3DNode & { setAllDirty?(): void })[])
        shape.setAllDirty?.();
    }

    override fieldChanged(): void {
      this.nodeChanged();
      for (const shape of this._parentNodes) shape.invalidateVolume();
    }
  };
}

/** Each corner of a triangle has a point of its own: normals, colours and textures may part there. */
function fill(node: GeometryNode, surface: Surface, crease: number, look: Look): void {
  const { points, index } = surface;
  const { _mesh: mesh, _vf: values } = node;
  const faceOf = (corner: number): number => {
    const triangle = Math.floor(corner / 3);
    return surface.faces?.[triangle] ?? triangle;
  };
  const each = <T>(list: T[], perVertex: unknown): (T | undefined)[] =>
    index.map((point, corner) => list[perVertex ? point : faceOf(corner)]);

  mesh._positions[0] = index.flatMap((i) => points.slice(3 * i, 3 * i + 3));
  mesh._indices[0] = index.map((_, corner) => corner);
  const given = look.normals && whole(each(look.normals, values.normalPerVertex));
  mesh._normals[0] = given
    ? given.flatMap(({ x, y, z }) => [x, y, z])
    : normalsOf(surface, crease).map((value) => (values.ccw ? value : -value));
  mesh._texCoords[0] = texCoordsOf(surface, look.texCoords);
  const colors = look.colors && whole(each(look.colors, values.colorPerVertex));
  const hasAlpha = colors?.[0]?.a !== undefined;
  mesh._colors[0] = (colors ?? []).flatMap(({ r, g, b, a }) =>
    hasAlpha ? [r, g, b, a] : [r, g, b],
  );
  mesh._numColComponents = hasAlpha ? 4 : 3;
  mesh._numFaces = index.length / 3;
  mesh._numCoords = index.length;
}

/** All of them, or none. */
const whole = <T>(list: (T | undefined)[]): T[] | undefined =>
  list.every((item) => item !== undefined) ? (list as T[]) : undefined;

/** The author's, by point; else the geometry's own; else those of its largest sides. */
function texCoordsOf({ points, index, texCoords, texIndex }: Surface, given?: Point[]): number[] {
  const own = given && whole(index.map((i) => given[i]));
  if (own) return own.flatMap(({ x, y }) => [x, y]);
  const all = texCoords ?? onLargestSides(points);
  return (texIndex ?? index).flatMap((i) => [all[2 * i], all[2 * i + 1]]);
}

/** X3D's for sets: along the largest side of the box around it from 0 to 1, along the next one in the same scale. */
function onLargestSides(points: number[]): number[] {
  const sides = [0, 1, 2].map((axis) => {
    const values = points.filter((_, i) => i % 3 === axis);
    const least = values.reduce((a, b) => Math.min(a, b), Infinity);
    return { values, least, size: values.reduce((a, b) => Math.max(a, b), -Infinity) - least };
  });
  const [s, t] = sides.sort((a, b) => b.size - a.size);
  const scale = s.size || 1;
  return s.values.flatMap((value, i) => [
    (value - s.least) / scale,
    (t.values[i] - t.least) / scale,
  ]);
}
