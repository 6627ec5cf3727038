import type { NodeType } from './dom.js';
import { fieldsByAttribute } from './fields.js';

/** Attributes that any element of a page or any X3D node may have. */
const COMMON = new Set([
  'def',
  'use',
  'id',
  'class',
  'style',
  'slot',
  'title',
  'lang',
  'hidden',
  'part',
  'is',
  'key',
  'ref',
  'containerfield',
  'name',
  'metadata',
  'render',
  'visible',
  'bboxcenter',
  'bboxsize',
  'bboxdisplay',
  'bboxmargin',
  'bboxcolor',
]);
const COMMON_PREFIX = /^(on|data-|aria-|xml|xsi:|_|:|@)/;

/** Additions of ours that say something about structure, and so are no fields. */
export const STRUCTURE: Record<string, string[]> = {
  RigidBodyCollection: ['default', 'shared-world', 'batch'],
  RigidBody: ['for', 'batch'],
  CollidableShape: ['for'],
  WaterVolume: ['for'],
  Rope: ['for'],
  Cloth: ['for'],
  SoftBody: ['for'],
};

export function known(type: NodeType, name: string): boolean {
  const lower = name.toLowerCase();
  return (
    COMMON.has(lower) ||
    COMMON_PREFIX.test(lower) ||
    (STRUCTURE[type.name]?.includes(lower) ?? false) ||
    fieldsByAttribute(type).has(lower)
  );
}
