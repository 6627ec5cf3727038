import type { X3DNode } from '../x3dom/x3dom.js';
import type { X3DColor, X3DShape } from '../x3dom/renderer.js';
import { isScaled } from './boxes.js';
import { typeOf } from './types.js';

// What makes two Shapes look alike, by content. What is not listed here is left to x3dom.

/** Geometry whose pictures were compared. */
const GEOMETRY = new Set(['Box', 'Sphere', 'Cylinder', 'Cone', 'IndexedFaceSet']);

/** The same of what an Appearance has, by its field. */
const APPEARANCE: Record<string, string> = {
  material: 'Material',
  texture: 'ImageTexture',
};

/** Each body has its own; and what x3dom notes when an image has come, at the first who shows it. */
const NOT_OF_THE_LOOK = new Set(['diffuseColor', 'origChannelCount']);

const WHITE: X3DColor = { r: 1, g: 1, b: 1 };

const nodesOf = (field: X3DNode['_cf'][string]): X3DNode[] =>
  field.nodes ?? (field.node ? [field.node] : []);

export const geometryOf = (shape: X3DNode): X3DNode | null | undefined => shape._cf.geometry.node;
export const appearanceOf = (shape: X3DNode): X3DNode | null | undefined =>
  shape._cf.appearance.node;

const materialOf = (shape: X3DNode): X3DNode | null | undefined =>
  appearanceOf(shape)?._cf.material.node;

/** What x3dom takes where there is no Material is white. */
export const colorOf = (shape: X3DNode): X3DColor =>
  (materialOf(shape)?._vf.diffuseColor as X3DColor | undefined) ?? WHITE;

/** Why a Shape is drawn by itself; undefined where it need not be. */
export function obstacle(shape: X3DShape): string | undefined {
  const geometry = geometryOf(shape);
  if (!geometry) return 'it has no geometry';
  if (!GEOMETRY.has(typeOf(geometry))) return `its ${typeOf(geometry)} is drawn by itself`;
  if (!geometry._mesh?._positions[0]?.length) return 'its geometry is empty';
  const appearance = appearanceOf(shape);
  if (!appearance) return undefined;
  for (const [name, field] of Object.entries(appearance._cf)) {
    if (name === 'metadata') continue;
    for (const node of nodesOf(field))
      if (typeOf(node) !== APPEARANCE[name]) return `its ${typeOf(node)} is drawn by itself`;
  }
  return isTransparent(appearance) ? 'it is transparent' : undefined;
}

/** What is seen through is drawn from the back to the front, whatever it looks like. */
export function isTransparent(appearance: X3DNode): boolean {
  return String(appearance._vf.sortType).toLowerCase() !== 'opaque';
}

/** What the look of a Shape consists of, in words. Nodes that many Shapes share are read once. */
export class Looks {
  readonly #read = new Map<X3DNode, string>();

  of(shape: X3DShape): string {
    const parts = [geometryOf(shape), appearanceOf(shape)];
    return [shape._vf.isPickable, ...parts.map((node) => (node ? this.#content(node) : ''))].join(
      '|',
    );
  }

  #content(node: X3DNode): string {
    const known = this.#read.get(node);
    if (known !== undefined) return known;
    const scaled = isScaled(node) ? 'size' : undefined;
    const values = Object.entries(node._vf).map(([name, value]) =>
      NOT_OF_THE_LOOK.has(name) || name === scaled ? '' : inWords(value),
    );
    const nodes = Object.entries(node._cf).flatMap(([name, field]) =>
      name === 'metadata' ? [] : nodesOf(field).map((each) => `${name}:${this.#content(each)}`),
    );
    // Of a grey image the colour is multiplied, of any other one it is replaced.
    const blends = (node as { _blending?: boolean })._blending ? 'blends' : '';
    const content = `${typeOf(node)}${blends}(${values.join(';')}{${nodes.join()}})`;
    this.#read.set(node, content);
    return content;
  }

  /** What was read may be otherwise by the next frame. */
  forget(): void {
    this.#read.clear();
  }
}

/** x3dom's values tell themselves, lists do so by what they hold. */
const inWords = (value: unknown): string =>
  Array.isArray(value) ? Array.prototype.join.call(value, ',') : String(value);
