import type { Field } from '../words/dom.js';
import { axisAngleOf, quaternionOf } from '../geometry/matrix.js';
import { holdsNodes } from '../words/fields.js';
import type { X3DNode, X3DOM, X3DQuaternion, X3DVector } from './x3dom.js';

/** A value of ours as x3dom's fields have it, for ROUTEs and getFieldValue. */
export function toX3DOM(field: Field, value: unknown, { fields }: X3DOM): unknown {
  if (value === undefined) return undefined;
  const list = value as number[];
  switch (field.type) {
    case 'SFVec2f':
      return new fields.SFVec2f(list[0], list[1]);
    case 'SFVec3f':
      return new fields.SFVec3f(list[0], list[1], list[2]);
    case 'SFRotation':
      return new fields.Quaternion(...quaternionOf(list));
    case 'MFVec3f':
      return new fields.MFVec3f(
        (value as number[][]).map(([x, y, z]) => new fields.SFVec3f(x, y, z)),
      );
    case 'MFString':
      return new fields.MFString(value as unknown[]);
    case 'MFFloat':
      return new fields.MFFloat(value as unknown[]);
    default:
      return value;
  }
}

/** What x3dom, or a script through setFieldValue, hands over: x3dom's objects, arrays, text or plain values. */
export function fromX3DOM(field: Field, value: unknown): unknown {
  if (value === null || typeof value !== 'object') return value;
  if (holdsNodes(field)) return elementsOf(value);
  if (field.type === 'SFRotation' && 'w' in value) {
    const { x, y, z, w } = value as X3DQuaternion;
    return axisAngleOf([x, y, z, w]);
  }
  if (field.type === 'MFVec3f') return Array.from(value as Iterable<unknown>, coordinates);
  return field.type === 'SFVec2f' || field.type === 'SFVec3f' ? coordinates(value) : value;
}

/** x3dom's nodes as their elements; elements, and contacts as plain objects, stay. */
function elementsOf(value: unknown): unknown {
  if (typeof value !== 'object' || value === null || value instanceof Element) return value;
  if (Symbol.iterator in value) return Array.from(value as Iterable<unknown>, elementsOf);
  return '_xmlNode' in value ? (value as X3DNode)._xmlNode : value;
}

function coordinates(value: unknown): unknown {
  if (value === null || typeof value !== 'object' || !('x' in value)) return value;
  const { x, y, z } = value as X3DVector;
  return z === undefined ? [x, y] : [x, y, z];
}
