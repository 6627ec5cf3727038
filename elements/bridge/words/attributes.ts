import { advice, meant, show, type ProblemReport } from '../../../physics-core/inside.js';
import { attribute, type NodeType } from './dom.js';
import { attributeOf, fieldsByAttribute } from './fields.js';

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

/** An element as messages call it. */
interface Labelled {
  element: Element;
  type: NodeType;
  label: string;
}

export function unknownAttribute({ element, type, label }: Labelled, name: string): ProblemReport {
  return {
    code: 'unknown-attribute',
    severity: 'warning',
    attribute: name,
    value: attribute(element, name),
    used: 'nothing',
    message: `${label} has no attribute ${show(name)}${meant({ name, type: type.name, value: attribute(element, name) }, attributesOf(type))}`,
  };
}

let missing = false;

/** Whether there is advice by now, or can't be: until then nobody is told of names that there are not. `again` is called then. */
export function canAdvise(again: () => void): boolean {
  if (advice.here || missing) return true;
  advice
    .load()
    .catch(() => (missing = true))
    .finally(again);
  return false;
}

const attributesOf = (type: NodeType): string[] => [
  ...Object.entries(type.fields).map(([field, entry]) => attributeOf(field, entry)),
  ...(STRUCTURE[type.name] ?? []),
];
