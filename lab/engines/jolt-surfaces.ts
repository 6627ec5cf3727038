import type { Heights, Triangles, Vec3 } from '../case.js';
import { cornersOf } from './bodies.js';
import { NotOffered } from './engine.js';
import type { Jolt } from './jolt-joints.js';

type Shape = InstanceType<Jolt['Shape']>;

/** Destroys what is made in the end. */
interface Maker {
  jolt: Jolt;
  own<T extends object>(object: T): T;
  vec(v: Vec3): InstanceType<Jolt['Vec3']>;
}

/** The settings hold it, too. */
function made(maker: Maker, settings: InstanceType<Jolt['ShapeSettings']>): Shape {
  const result = maker.own(settings).Create();
  if (result.HasError()) throw new Error(result.GetError().c_str());
  return result.Get();
}

export function hullOf(maker: Maker, { coord }: Triangles): Shape {
  const settings = new maker.jolt.ConvexHullShapeSettings();
  for (const corner of cornersOf(coord)) settings.mPoints.push_back(maker.vec(corner));
  return made(maker, settings);
}

export function meshOf(maker: Maker, { coord, index }: Triangles): Shape {
  const { jolt } = maker;
  const corners = cornersOf(coord).map((corner) => maker.vec(corner));
  const list = maker.own(new jolt.TriangleList());
  for (let i = 0; i < index.length; i += 3) {
    const [a, b, c] = index.slice(i, i + 3).map((corner) => corners[corner]!);
    list.push_back(maker.own(new jolt.Triangle(a!, b!, c!, 0)));
  }
  return made(maker, new jolt.MeshShapeSettings(list));
}

export function fieldOf(maker: Maker, grid: Heights): Shape {
  const { xDimension, zDimension, xSpacing, zSpacing, height } = grid;
  if (xDimension !== zDimension) throw new NotOffered('fields of heights that are not square');
  const settings = new maker.jolt.HeightFieldShapeSettings();
  settings.mSampleCount = xDimension;
  settings.mScale = maker.vec([xSpacing, 1, zSpacing]);
  for (const value of height) settings.mHeightSamples.push_back(value);
  return made(maker, settings);
}
