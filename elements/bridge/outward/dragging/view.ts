import type { Vec3 } from '../../../../physics-core/inside.js';
import { x3dom, type X3DElement, type X3DProjection, type X3DViewarea } from '../../x3dom/x3dom.js';

/** A line of sight, in the lengths of the scene: from where the picture begins to where it ends. */
export interface Sight {
  from: Vec3;
  to: Vec3;
  /** How far beside it somebody may mean what is thin, at either end. */
  beside: [near: number, far: number];
}

/** CSS pixels by which a pointer misses a rope and still means it. */
const BESIDE = 6;

const along = (a: Vec3, b: Vec3, share: number): Vec3 => [
  a[0] + (b[0] - a[0]) * share,
  a[1] + (b[1] - a[1]) * share,
  a[2] + (b[2] - a[2]) * share,
];

export const minus = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const plus = (a: Vec3, b: Vec3, times = 1): Vec3 => [
  a[0] + b[0] * times,
  a[1] + b[1] * times,
  a[2] + b[2] * times,
];
const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const size = (a: Vec3): number => Math.hypot(...a);
const unit = (a: Vec3): Vec3 => a.map((value) => value / (size(a) || 1)) as Vec3;

function mapped(projection: X3DProjection, x: number, y: number, z: number): Vec3 {
  const { fields } = x3dom()!;
  const point = projection.multFullMatrixPnt(new fields.SFVec3f(x, y, z));
  return [point.x, point.y, point.z];
}

/** The picture that x3dom draws of an `<x3d>`: what lies under a point of it, and where a point of the scene shows. */
export class View {
  readonly #x3d: X3DElement;

  constructor(x3d: Element) {
    this.#x3d = x3d;
  }

  get canvas(): HTMLCanvasElement | undefined {
    return this.#x3d.runtime?.canvas?.canvas;
  }

  get #area(): X3DViewarea | undefined {
    return this.#x3d.runtime?.canvas?.doc?._viewarea;
  }

  /** To x3dom no button is down. */
  forgetPress(): void {
    const canvas = this.canvas as (HTMLCanvasElement & { mouse_dragging?: boolean }) | undefined;
    const area = this.#area;
    if (canvas) canvas.mouse_dragging = false;
    // It takes a release where it was pressed for a click that turns the camera.
    if (area) [area._lastButton, area._pressX] = [0, NaN];
  }

  /** Through a point of the page, CSS pixels of the window. */
  sight(clientX: number, clientY: number): Sight | undefined {
    const { canvas } = this;
    const inverse = this.#area?.getCCtoWCMatrix();
    if (!canvas || !inverse) return undefined;
    const { left, top, width, height } = canvas.getBoundingClientRect();
    const x = (2 * (clientX - left)) / width - 1;
    const y = 1 - (2 * (clientY - top)) / height;
    const [from, to] = [mapped(inverse, x, y, -1), mapped(inverse, x, y, 1)];
    const aside = (2 * BESIDE) / height;
    const off = (end: Vec3, z: number): number =>
      size(minus(mapped(inverse, x, y + aside, z), end));
    return { from, to, beside: [off(from, -1), off(to, 1)] };
  }

  /** Where a line of sight meets the plane through `point` that faces the viewer. */
  meet({ from, to }: Pick<Sight, 'from' | 'to'>, point: Vec3): Vec3 | undefined {
    const normal = this.ahead();
    const way = normal && dot(normal, minus(to, from));
    if (!normal || !way) return undefined;
    return along(from, to, dot(normal, minus(point, from)) / way);
  }

  /** Where the viewer looks. */
  ahead(): Vec3 | undefined {
    const inverse = this.#area?.getCCtoWCMatrix();
    return inverse && unit(minus(mapped(inverse, 0, 0, 1), mapped(inverse, 0, 0, -1)));
  }

  /** A point of the scene as one of the window, CSS pixels; undefined where it is behind the viewer. */
  place(point: Vec3): { x: number; y: number } | undefined {
    const { canvas } = this;
    const projection = this.#area?.getWCtoCCMatrix();
    if (!canvas || !projection) return undefined;
    const [x, y, z] = mapped(projection, ...point);
    const { left, top, width, height } = canvas.getBoundingClientRect();
    if (Math.abs(z) > 1) return undefined;
    return { x: left + ((x + 1) / 2) * width, y: top + ((1 - y) / 2) * height };
  }

  /** What one CSS pixel to the right, or up, is in the scene at the depth of a point. */
  pixel(point: Vec3): { right: Vec3; up: Vec3 } | undefined {
    const { canvas } = this;
    if (!canvas) return undefined;
    const { left, top, width, height } = canvas.getBoundingClientRect();
    const [x, y] = [left + width / 2, top + height / 2];
    const at = (dx: number, dy: number): Vec3 | undefined => {
      const sight = this.sight(x + dx, y + dy);
      return sight && this.meet(sight, point);
    };
    const [middle, right, up] = [at(0, 0), at(1, 0), at(0, -1)];
    return middle && right && up && { right: minus(right, middle), up: minus(up, middle) };
  }
}
