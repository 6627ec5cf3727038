import { codecs, show } from '../../../physics-core/inside.js';
import type { Binding } from '../nodes/binding.js';
import { attribute, isPhysics, isShape, isTransform, lowerName } from '../words/dom.js';
import {
  geometryFields,
  hasCoord,
  knownGeometry,
  type GeometryData,
} from '../geometry/geometry-fields.js';
import { axisAngleOf, decompose, identity, multiply, type Affine } from '../geometry/matrix.js';
import type { Scope } from '../scopes/scope.js';
import { localMatrix } from '../scopes/transforms.js';
import { nodeOf } from '../x3dom/x3dom.js';

/** Reads the geometry of Shapes for one node, which is told when something it read changes. */
export class GeometryReader {
  readonly #user: Binding;
  readonly found: GeometryData[] = [];
  /** One of the Shapes has no geometry that could be used. */
  waiting = false;

  constructor(user: Binding) {
    this.#user = user;
  }

  /** All Shapes at and under `root` that no nearer body owns; `matrix` takes root's own frame to the collidable's. */
  collect(root: Element, scope: Scope, matrix: Affine = identity()): void {
    this.#watch(root);
    const use = attribute(root, 'USE');
    const element = use ? scope.find(use, this.#user) : root;
    if (!element) return;
    if (element !== root) this.#watch(element);
    if (isShape(element)) this.#shape(element, scope, matrix);
    else for (const child of element.children) this.#child(child, scope, matrix);
  }

  /** The first of some elements that is a geometry itself: a massDensityModel. */
  single(elements: Element[], scope: Scope): GeometryData | undefined {
    const geometry = elements.find((element) => knownGeometry(lowerName(element)));
    return geometry && this.#geometry(geometry, scope);
  }

  #child(child: Element, scope: Scope, matrix: Affine): void {
    if (isPhysics(child)) return;
    const use = attribute(child, 'USE');
    const element = use ? scope.find(use, this.#user) : child;
    if (!element) return;
    if (!isTransform(element)) return this.collect(child, scope, matrix);
    // A Transform with a body of its own moves by itself, as long as it has one.
    if (this.#user.scene!.drivers.of(element)) return this.#watch(element);
    this.collect(child, scope, multiply(matrix, localMatrix(element)));
  }

  #shape(shape: Element, scope: Scope, matrix: Affine): void {
    this.#watch(shape);
    const before = this.found.length;
    for (const child of shape.children) {
      const use = attribute(child, 'USE');
      const element = (use ? scope.find(use, this.#user) : child) ?? child;
      const data = this.#geometry(element, scope);
      if (!data) continue;
      this.found.push(placed(data, matrix, scope.units.length));
    }
    if (this.found.length === before) this.waiting = true;
  }

  #geometry(element: Element, scope: Scope): GeometryData | undefined {
    this.#watch(element);
    const type = knownGeometry(lowerName(element));
    if (!type) return meshOf(element, scope.units.length);
    const data: GeometryData = { type };
    for (const [name, field] of Object.entries(geometryFields[type])) {
      const text = attribute(element, name);
      if (text === null) continue;
      const value = codecs[field.type].parse(text);
      if (value === undefined) this.#malformed(element, name, text);
      else
        data[name] = field.length ? scaled(value as number | number[], scope.units.length) : value;
    }
    if (hasCoord(type)) data.coord = this.#coord(element, scope);
    return data;
  }

  #coord(geometry: Element, scope: Scope): number[] {
    for (const child of geometry.children) {
      const use = attribute(child, 'USE');
      const element = (use ? scope.find(use, this.#user) : child) ?? child;
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
    this.#user.problem({
      code: 'bad-value',
      severity: 'warning',
      attribute: name,
      value: text,
      message: `<${element.localName}> ${name}="${show(text)}" can't be read; X3D's default is used`,
    });
  }
}

const scaled = (value: number | number[], factor: number): number | number[] =>
  factor === 1 ? value : Array.isArray(value) ? value.map((item) => item * factor) : value * factor;

/** Where a geometry sits in the collidable's frame, in metres. */
function placed(data: GeometryData, matrix: Affine, length: number): GeometryData {
  const { position, quaternion, linear } = decompose(matrix);
  if (position.some((value) => value !== 0))
    data.translation = position.map((value) => value * length);
  if (quaternion[3] !== 1) data.rotation = axisAngleOf(quaternion);
  if (linear) data.linear = linear;
  return data;
}

/** The triangles that x3dom made of a geometry we have no table for: Torus, Extrusion, Pyramid, … */
function meshOf(element: Element, length: number): GeometryData | undefined {
  const mesh = nodeOf(element)?._mesh;
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
