import type { X3DMesh } from '../x3dom/x3dom.js';
import { scaleIn } from './frame.js';
import type { Look, Shown } from './look.js';

/** What each particle is drawn as. */
export interface Form {
  primitive: 'TRIANGLES' | 'LINES' | 'POINTS';
  /** Points of one particle. */
  corners: number;
  index: ArrayLike<number>;
  normals: ArrayLike<number>;
  texCoords: ArrayLike<number>;
  /** How far it reaches from its first point, in what x3dom draws. */
  reach: number;
  /** Whether it is turned to who looks. */
  faces: boolean;
  /** Writes the corners of the particle at `from` to `out`; `basis`: right, up and back of who looks. */
  place(
    motion: Float64Array,
    from: number,
    shown: Shown,
    basis: Float64Array | undefined,
    out: Float32Array,
    at: number,
  ): void;
}

const SQUARE = [-0.5, -0.5, 0.5, -0.5, 0.5, 0.5, -0.5, 0.5];
const OF_QUAD = [0, 1, 2, 0, 2, 3];
const FORWARD = [0, 0, 1];

const times = <T>(count: number, list: readonly T[]): T[] =>
  Array.from({ length: count }, () => list).flat();

/** By geometryType; GEOMETRY without one that has triangles is drawn as points. */
export function formOf(look: Look): Form {
  const { type, geometry } = look;
  if (type === 'POINT') return point();
  if (type === 'LINE') return line(look);
  if (type === 'GEOMETRY')
    return geometry?._primType === 'TRIANGLES' ? ofMesh(geometry as GivenMesh, look) : point();
  const apart = type === 'TRIANGLE' ? OF_QUAD : [0, 1, 2, 3];
  return square(look, apart, type === 'SPRITE');
}

const point = (): Form => ({
  primitive: 'POINTS',
  corners: 1,
  index: [0],
  normals: [],
  texCoords: [],
  reach: 0,
  faces: false,
  place: (motion, from, { since, length }, _, out, at) => {
    for (let i = 0; i < 3; i++)
      out[at + i] = (motion[from + i]! - since * motion[from + 3 + i]!) / length;
  },
});

/** Along the way that it goes, as long as the system's particles are high, about its middle. */
function line({ size }: Look): Form {
  const half = size[1] / 2;
  return {
    primitive: 'LINES',
    corners: 2,
    index: [0, 1],
    normals: [],
    texCoords: [0, 0, 1, 0],
    reach: size[1],
    faces: false,
    place: (motion, from, { since, length }, _, out, at) => {
      const speed = Math.hypot(motion[from + 3]!, motion[from + 4]!, motion[from + 5]!);
      for (let i = 0; i < 3; i++) {
        const velocity = motion[from + 3 + i]!;
        const middle = motion[from + i]! - since * velocity;
        const arm = speed > 0 ? (half * velocity) / speed : 0;
        out[at + i] = (middle - arm) / length;
        out[at + 3 + i] = (middle + arm) / length;
      }
    },
  };
}

/** A rectangle; in the frame's own plane of x and y, or facing who looks. */
function square({ size, frame }: Look, apart: readonly number[], faces: boolean): Form {
  const offsets = apart.map((corner) => [
    SQUARE[2 * corner]! * size[0],
    SQUARE[2 * corner + 1]! * size[1],
  ]);
  const own = unitAxes(frame);
  return {
    primitive: 'TRIANGLES',
    corners: apart.length,
    index: apart.length === 4 ? OF_QUAD : apart.map((_, i) => i),
    normals: times(apart.length, faces ? FORWARD : own.slice(6)),
    texCoords: apart.flatMap((corner) => [
      SQUARE[2 * corner]! + 0.5,
      SQUARE[2 * corner + 1]! + 0.5,
    ]),
    reach: Math.hypot(...size),
    faces,
    place: (motion, from, { since, length }, basis, out, at) => {
      const turn = basis ?? own;
      for (let i = 0; i < 3; i++) {
        const middle = motion[from + i]! - since * motion[from + 3 + i]!;
        const right = turn[i]!;
        const up = turn[3 + i]!;
        for (let corner = 0; corner < offsets.length; corner++) {
          const offset = offsets[corner]!;
          out[at + 3 * corner + i] = (middle + offset[0]! * right + offset[1]! * up) / length;
        }
      }
    },
  };
}

/** The axes of a frame, each as long as 1: x, y, z. */
function unitAxes(matrix: readonly number[]): number[] {
  return [0, 1, 2].flatMap((axis) => {
    const way = [matrix[axis]!, matrix[4 + axis]!, matrix[8 + axis]!];
    const length = Math.hypot(...way) || 1;
    return way.map((each) => each / length);
  });
}

interface GivenMesh extends X3DMesh {
  _normals: ArrayLike<number>[];
  _texCoords: ArrayLike<number>[];
}

/** The triangles of a geometry, as its frame scales and turns them, about where the particle is. */
function ofMesh({ _positions, _indices, _normals, _texCoords }: GivenMesh, { frame }: Look): Form {
  const points = turned(_positions[0] ?? [], frame);
  const scale = scaleIn(frame) || 1;
  return {
    primitive: 'TRIANGLES',
    corners: points.length / 3,
    index: _indices[0] ?? [],
    normals: turned(
      _normals[0] ?? [],
      frame.map((value) => value / scale),
    ),
    texCoords: _texCoords[0] ?? [],
    reach: 2 * points.reduce((most, value) => Math.max(most, Math.abs(value)), 0),
    faces: false,
    place: (motion, from, { since, length }, _, out, at) => {
      for (let i = 0; i < 3; i++) {
        const middle = (motion[from + i]! - since * motion[from + 3 + i]!) / length;
        for (let k = i; k < points.length; k += 3) out[at + k] = middle + points[k]!;
      }
    },
  };
}

function turned(list: ArrayLike<number>, m: readonly number[]): Float32Array {
  const out = new Float32Array(list.length);
  for (let k = 0; k < list.length; k += 3)
    for (let i = 0; i < 3; i++)
      out[k + i] =
        m[4 * i]! * list[k]! + m[4 * i + 1]! * list[k + 1]! + m[4 * i + 2]! * list[k + 2]!;
  return out;
}
