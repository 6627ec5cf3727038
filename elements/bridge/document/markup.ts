import { nearest, show } from '../../../physics-core/inside.js';
import { attribute, isHTML, isPhysics, lowerName, typeOf, type NodeType } from './dom.js';
import { attributeOf, fieldsByAttribute } from '../nodes/fields.js';
import type { Binding } from '../nodes/binding.js';
import type { Report } from '../nodes/findings.js';

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
  RigidBodyCollection: ['default', 'shared-world'],
  RigidBody: ['for'],
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

export function unknownAttribute({ element, type, label }: Binding, name: string): Report {
  const meant = nearest(name, attributesOf(type));
  return {
    code: 'unknown-attribute',
    severity: 'warning',
    attribute: name,
    value: attribute(element, name),
    used: 'nothing',
    message: `${label} has no attribute ${show(name)}${meant ? `; did you mean ${meant}?` : ''}`,
  };
}

const attributesOf = (type: NodeType): string[] => [
  ...Object.entries(type.fields).map(([field, entry]) => attributeOf(field, entry)),
  ...(STRUCTURE[type.name] ?? []),
];

/** What may not stand in what: these pairs come from a tag that the author thought closed, or are misplaced. */
const IMPOSSIBLE: Record<string, RegExp> = {
  RigidBody: /rigid-?body|joint|collision|^shape$|^transform$|^scene$/,
  CollidableShape: /rigid-?body|joint|collision|collidable/,
  CollidableOffset: /rigid-?body|joint|collision/,
  CollisionCollection: /rigid-?body|joint|collision-?(collection|sensor)/,
  RigidBodyCollection: /rigid-?body-?collection|collidable|^scene$/,
};
const JOINT_CHILD = /joint|collision|rigid-?body-?collection|^shape$|^transform$/;

/** Looks at the markup of one element, as the author wrote it. */
export function checkMarkup(binding: Binding): void {
  const { element, type } = binding;
  for (const { name } of element.attributes) {
    if (!known(type, name)) binding.problem(unknownAttribute(binding, name));
  }
  for (const report of binding.refused) binding.problem(report);
  const impossible =
    IMPOSSIBLE[type.name] ?? (type.name.endsWith('Joint') ? JOINT_CHILD : undefined);
  const child =
    impossible && [...element.children].find((each) => impossible.test(lowerName(each)));
  if (child) binding.problem(misplacedChild(binding, child));
  if (binding.scope!.firstForeign(binding)) binding.problem(NOT_UPGRADED);
  const def = attribute(element, 'DEF');
  if (def && binding.scope!.names.bearers(def).at(-1) !== element)
    binding.problem(duplicate(def, binding));
}

const NOT_UPGRADED: Report = {
  code: 'not-upgraded',
  severity: 'info',
  message:
    'hyphenated tags outside the XHTML namespace are no custom elements: they simulate, but have no properties and methods',
};

const duplicate = (def: string, { label }: Binding): Report => ({
  code: 'duplicate-def',
  severity: 'warning',
  attribute: 'DEF',
  value: def,
  used: 'the later element',
  message: `${label} shares its DEF with a later element, and a USE means the later one`,
});

function misplacedChild({ element, type, label }: Binding, child: Element): Report {
  // A collection that is thought closed swallows whole bodies and collections, not single collidables.
  const stray = type.name === 'RigidBodyCollection' && /collidable/.test(lowerName(child));
  const swallowed = isHTML(element) && !stray && (isPhysics(child) || lowerName(child) === 'scene');
  return swallowed
    ? {
        code: 'self-closing',
        severity: 'error',
        value: child.localName,
        used: 'the markup as HTML reads it',
        message: `${label} has swallowed <${child.localName}>: HTML knows no self-closing tags, write <${element.localName}></${element.localName}>`,
      }
    : {
        code: 'misplaced',
        severity: 'warning',
        value: child.localName,
        used: 'nothing',
        message: `<${child.localName}> can't stand in ${label}${lowerName(child) === 'shape' ? '; put it into a CollidableShape' : ''}`,
      };
}

/** The types a physics child may be, given by its name: used where roles are told apart. */
export const isType = (element: Element, ...names: string[]): boolean => {
  const type = typeOf(element);
  return type !== undefined && names.includes(type.name);
};

export const containerField = (element: Element): string | null =>
  attribute(element, 'containerField');
