import type { ProblemReport } from '../../../physics-core/inside.js';
import type { Binding } from '../nodes/binding.js';
import type { Scope } from '../scopes/scope.js';
import { canAdvise, known, unknownAttribute } from '../words/attributes.js';
import { attribute, isCustom, isHTML, isPhysics, lowerName } from '../words/dom.js';

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
  const unknown = [...element.attributes].filter(({ name }) => !known(type, name));
  if (unknown.length > 0 && canAdvise(() => binding.dirty()))
    for (const { name } of unknown) binding.problem(unknownAttribute(binding, name));
  for (const report of binding.refused) binding.problem(report);
  const impossible =
    IMPOSSIBLE[type.name] ?? (type.name.endsWith('Joint') ? JOINT_CHILD : undefined);
  const child =
    impossible && [...element.children].find((each) => impossible.test(lowerName(each)));
  if (child) binding.problem(misplacedChild(binding, child));
  if (isFirstForeign(binding)) binding.problem(NOT_UPGRADED);
  const def = attribute(element, 'DEF');
  if (def && binding.scope!.names.bearers(def).at(-1) !== element)
    binding.problem(duplicate(def, binding));
}

/** By scope: the one that says that hyphenated tags there are no custom elements. */
const foreign = new WeakMap<Scope, Binding>();

function isFirstForeign(binding: Binding): boolean {
  const { element } = binding;
  const scope = binding.scope!;
  if (!element.localName.startsWith('x3d-') || isCustom(element)) return false;
  const first = foreign.get(scope);
  if (first?.scope === scope) return first === binding;
  foreign.set(scope, binding);
  return true;
}

const NOT_UPGRADED: ProblemReport = {
  code: 'not-upgraded',
  severity: 'info',
  message:
    'hyphenated tags outside the XHTML namespace are no custom elements: they simulate, but have no properties and methods',
};

const duplicate = (def: string, { label }: Binding): ProblemReport => ({
  code: 'duplicate-def',
  severity: 'warning',
  attribute: 'DEF',
  value: def,
  used: 'the later element',
  message: `${label} shares its DEF with a later element, and a USE means the later one`,
});

function misplacedChild({ element, type, label }: Binding, child: Element): ProblemReport {
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
