import { codecs } from '../../../physics-core/inside.js';
import type { Binding } from '../nodes/binding.js';
import { attribute, isPhysics, isShape, isTransform, lowerName } from '../words/dom.js';
import {
  attributesOf,
  hasCoord,
  isLength,
  knownGeometry,
  type GeometryData,
} from '../geometry/geometry-fields.js';
import { axisAngleOf, decompose, identity, multiply, type Affine } from '../geometry/matrix.js';
import type { Scope } from '../scopes/scope.js';
import { localMatrix } from '../scopes/transforms.js';
import { cannotDraw } from '../x3dom/shapes/shapes.js';
import { nodeOf } from '../x3dom/x3dom.js';

/** Shapes with which nothing collides, wherever they stand: what is seen of water and of ropes. */
export const unsolid = new WeakSet<Element>();

/** Reads the geometry of Shapes for one node, which is told when something it read changes. */
export class GeometryReader {
  readonly #user: Binding;
  readonly found: GeometryData[] = [];
  /** What is being read: what stands in itself by USE is read but once. */
  readonly #reading = new Set<Element>();
  /** One of the Shapes has no geometry that could be used. */
  waiting = false;

  constructor(user: Binding) {
    this.#user = user;
  }

  /** All Shapes at and under `root` that no nearer body owns; `matrix` takes root's own frame to the collidable's. */
  collect(root: Element, around: Scope, matrix: Affine = identity()): void {
    this.#watch(root);
    const meant = meantBy(this.#user, root, around);
    if (!meant || this.#reading.has(meant.element)) return;
    const { element, scope } = meant;
    this.#reading.add(element);
    if (element !== root) this.#watch(element);
    if (isShape(element)) this.#shape(element, scope, matrix);
    else for (const child of element.children) this.#child(child, scope, matrix);
    this.#reading.delete(element);
  }

  /** The first of some elements that is a geometry itself: a massDensityModel. */
  single(
    elements: Element[],
    around: Scope,
    knows: (name: string) => unknown = knownGeometry,
  ): GeometryData | undefined {
    const geometry = elements.find((element) => knows(lowerName(element)));
    const meant = geometry && meantBy(this.#user, geometry, around);
    return meant && this.#geometry(meant.element, meant.scope);
  }

  #child(child: Element, around: Scope, matrix: Affine): void {
    if (isPhysics(child)) return;
    if (unsolid.has(child)) return this.#watch(child);
    const meant = meantBy(this.#user, child, around);
    if (!meant) return;
    const { element } = meant;
    if (!isTransform(element)) return this.collect(child, around, matrix);
    // A Transform with a body of its own moves by itself, as long as it has one.
    if (this.#user.scene!.drivers.of(element)) return this.#watch(element);
    this.collect(child, around, multiply(matrix, localMatrix(element)));
  }

  #shape(shape: Element, around: Scope, matrix: Affine): void {
    this.#watch(shape);
    const before = this.found.length;
    for (const child of shape.children) {
      const { element, scope } = meantBy(this.#user, child, around) ?? {
        element: child,
        scope: around,
      };
      const data = this.#geometry(element, scope);
      if (!data) continue;
      this.found.push(placed(data, matrix, scope.units.length));
    }
    if (this.found.length === before) this.waiting = true;
  }

  #geometry(element: Element, scope: Scope): GeometryData | undefined {
    this.#watch(element);
    if (cannotDraw(element)) this.#user.fault((faults) => faults.notDrawn(element));
    const type = knownGeometry(lowerName(element));
    if (!type) return meshOf(element, scope.units.length);
    const data: GeometryData = { type };
    for (const [name, fieldType] of attributesOf(type)) {
      const text = attribute(element, name);
      if (text === null) continue;
      const value = codecs[fieldType].parse(text);
      if (value === undefined) this.#malformed(element, name, text);
      else
        data[name] = isLength(fieldType)
          ? scaled(value as number | number[], scope.units.length)
          : value;
    }
    if (hasCoord(type)) data.coord = this.coord([...element.children], scope);
    return data;
  }

  /** The points of the first Coordinate among some elements. */
  coord(elements: Element[], around: Scope): number[] {
    for (const child of elements) {
      const { element, scope } = meantBy(this.#user, child, around) ?? {
        element: child,
        scope: around,
      };
      if (!/^coordinate(double)?$/.test(lowerName(element))) continue;
      this.#watch(element);
      const text = attribute(element, 'point') ?? '';
      const points = codecs.MFFloat.parse(text) as number[] | undefined;
      if (!points) this.#malformed(element, 'point', text);
      return scaled(points ?? [], scope.units.length) as number[];
    }
    return [];
  }

  #watch(element: Element): void {
    this.#user.scene!.readers.add(element, this.#user);
  }

  #malformed(element: Element, name: string, text: string): void {
    this.#user.fault((faults) => faults.malformed(element, name, text));
  }
}

/** An element, or what it stands for by USE, which may stand in another file. */
export function meantBy(
  user: Binding,
  element: Element,
  scope: Scope,
): { element: Element; scope: Scope } | undefined {
  const use = attribute(element, 'USE');
  if (!use) return { element, scope };
  const found = scope.find(use, user);
  return found && { element: found, scope: scope.all.around(found) ?? scope };
}

const scaled = (value: number | number[], factor: number): number | number[] =>
  factor === 1 ? value : Array.isArray(value) ? value.map((item) => item * factor) : value * factor;

/** Where a geometry sits in the collidable's frame, in metres. */
export function placed(data: GeometryData, matrix: Affine, length: number): GeometryData {
  const { position, quaternion, linear } = decompose(matrix);
  if (position.some((value) => value !== 0))
    data.translation = position.map((value) => value * length);
  if (quaternion[3] !== 1) data.rotation = axisAngleOf(quaternion);
  if (linear) data.linear = linear;
  return data;
}

/** The triangles that x3dom made of a geometry we have no table for: Torus, Extrusion, Pyramid, … */
function meshOf(element: Element, length: number): GeometryData | undefined {
  const { surface, _mesh: mesh } = nodeOf(element) ?? {};
  if (surface?.index.length)
    return { type: 'Mesh', points: scaled(surface.points, length), index: surface.index };
  if (!mesh || mesh._primType !== 'TRIANGLES') return undefined;
  const points: number[] = [];
  const index: number[] = [];
  mesh._positions.forEach((positions, part) => {
    const first = points.length / 3;
    for (let i = 0; i < positions.length; i++) points.push(positions[i] * length);
    const indices = mesh._indices[part];
    for (let i = 0; i < indices.length; i++) index.push(indices[i] + first);
  });
  return index.length > 0 ? { type: 'Mesh', points, index } : undefined;
}

export function noteWaiting(binding: Binding, reader: GeometryReader): void {
  // What names something that is not there has been told so already.
  if ((!reader.waiting && reader.found.length > 0) || binding.waiting.size > 0) return;
  binding.problem({
    code: 'waiting-for-geometry',
    severity: 'info',
    used: reader.found.length > 0 ? 'its other Shapes' : 'nothing',
    message: reader.waiting
      ? `${binding.label} has a Shape without a geometry that could collide`
      : `${binding.label} has no Shape that could collide`,
  });
}
