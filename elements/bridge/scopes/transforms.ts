import { codecs } from '../../../physics-core/inside.js';
import { attribute, isTransform, isX3D, lowerName } from '../words/dom.js';
import {
  identity,
  invert,
  matrixOf,
  multiply,
  quaternionOf,
  translationMatrix,
  type Affine,
} from '../geometry/matrix.js';
import type { Scope } from './scope.js';
import { drawnPlace } from './standing.js';
import { fromX3D, wasDrawn } from '../x3dom/matrices.js';
import { nodeOf } from '../x3dom/x3dom.js';

/** A numeric attribute in file units; absent or malformed: X3D's default. */
export function numbers(
  element: Element,
  name: string,
  type: 'SFVec3f' | 'SFRotation',
  otherwise: number[],
): number[] {
  const text = attribute(element, name);
  return ((text !== null && codecs[type].parse(text)) || otherwise) as number[];
}

const AXIS_Z = [0, 0, 1, 0];

/** The rotation of an element, axis and angle in radians. */
export function rotationOf(element: Element, angle: number, name = 'rotation'): number[] {
  const [x, y, z, turn] = numbers(element, name, 'SFRotation', AXIS_Z);
  return [x, y, z, turn * angle];
}

function turned(rotation: number[]): Affine {
  return matrixOf({ position: [0, 0, 0], quaternion: quaternionOf(rotation) });
}

/** X3D's formula for a Transform: T · C · R · SR · S · SR⁻¹ · C⁻¹ (ISO/IEC 19775-1, 10.4.4). */
export function composed(element: Element, angle: number): Affine {
  const [tx, ty, tz] = numbers(element, 'translation', 'SFVec3f', [0, 0, 0]);
  const [cx, cy, cz] = numbers(element, 'center', 'SFVec3f', [0, 0, 0]);
  const [sx, sy, sz] = numbers(element, 'scale', 'SFVec3f', [1, 1, 1]);
  const oriented = turned(rotationOf(element, angle, 'scaleOrientation'));
  const scale: Affine = [sx, 0, 0, 0, 0, sy, 0, 0, 0, 0, sz, 0];
  return [
    translationMatrix(tx + cx, ty + cy, tz + cz),
    turned(rotationOf(element, angle)),
    multiply(multiply(oriented, scale), invert(oriented)),
    translationMatrix(-cx, -cy, -cz),
  ].reduce((left, right) => multiply(left, right));
}

/**
 * The local matrix of a Transform as x3dom has it; from its attributes where x3dom has not read it yet.
 * x3dom knows no UNIT: what it draws is in file lengths, and it takes every angle for radians.
 */
export function localMatrix(element: Element): Affine {
  const trafo = nodeOf(element)?._trafo;
  return trafo ? fromX3D(trafo) : composed(element, 1);
}

/** The element around an element, where that is drawn: in a scope's root, what stands for that scope outside. */
export function outer(
  node: Element,
  around: Scope,
): { element: Element; scope: Scope } | undefined {
  const { element, scope } = drawnPlace(node, around);
  const parent = element.parentElement;
  if (element !== scope.root && parent && !isX3D(parent)) return { element: parent, scope };
  return scope.host && scope.parent ? { element: scope.host, scope: scope.parent } : undefined;
}

const PLACED = new Set([
  'collidableshape',
  'collidableoffset',
  'x3d-collidable-shape',
  'x3d-collidable-offset',
]);

/** World matrix of everything above an element, in the lengths that x3dom draws. */
export function matrixAbove(element: Element, scope: Scope): Affine {
  let matrix = identity();
  for (const at of allAbove(element, scope)) {
    if (isTransform(at) || PLACED.has(lowerName(at))) matrix = multiply(localMatrix(at), matrix);
  }
  return matrix;
}

/** What is above an element, nearest first. What stands in itself by USE is above itself but once. */
function* allAbove(element: Element, scope: Scope): Generator<Element> {
  const met = new Set([element]);
  for (
    let at = outer(element, scope);
    at && !met.has(at.element);
    at = outer(at.element, at.scope)
  ) {
    met.add(at.element);
    yield at.element;
  }
}

/** The Transforms above an element, nearest first. */
export function transformsAbove(element: Element, scope: Scope): Element[] {
  return [...allAbove(element, scope)].filter(isTransform);
}

/**
 * The local matrix of a Transform that a body moves. Its own angle is in the units of its file, unless what stands
 * in x3dom's matrix is what we drew.
 */
export function drivenMatrix(element: Element, { units }: Scope): Affine {
  const node = nodeOf(element);
  const plain = units.angle === 1 || (node !== undefined && wasDrawn(node));
  return plain ? localMatrix(element) : composed(element, units.angle);
}
