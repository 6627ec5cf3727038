// The chunk `faults`: what is wrong with the markup, in words.
import { advice, meant, show, type ProblemReport } from '../../../physics-core/inside.js';
import {
  attribute,
  isPhysics,
  kebab,
  knownTypes,
  lowerName,
  nameOf,
  type NodeType,
} from './dom.js';
import { isHTML } from './is-html.js';
import { attributeOf } from './fields.js';
import { STRUCTURE } from './attributes.js';
import type { Faults, Labelled } from './faults.js';

export const provide = (): Faults => ({
  unknownAttribute,
  misplacedChild,
  undrawn,
  otherTag,
  duplicate,
  notUpgraded: () => NOT_UPGRADED,
  circle,
  nested,
  owned,
  rival,
  namedCollidables,
  unmoved,
  unused,
  malformed,
  otherPhysics: () => OTHER_PHYSICS,
  refusedRoute,
  twoCopies: () => TWO_COPIES,
  outside,
  swallowed,
  late,
  stranger,
  unread,
  notDrawn,
});

function unknownAttribute({ element, type, label }: Labelled, name: string): ProblemReport {
  const value = attribute(element, name);
  const answer = meant({ name, type: type.name, value }, attributesOf(type));
  return {
    code: 'unknown-attribute',
    severity: 'warning',
    attribute: name,
    value,
    used: 'nothing',
    message: `${label} has no attribute ${show(name)}${answer}`,
  };
}

const attributesOf = (type: NodeType): string[] => [
  ...Object.entries(type.fields).map(([field, entry]) => attributeOf(field, entry)),
  ...(STRUCTURE[type.name] ?? []),
];

const NOT_UPGRADED: ProblemReport = {
  code: 'not-upgraded',
  severity: 'info',
  message:
    'hyphenated tags outside the XHTML namespace are no custom elements: they simulate, but have no properties and methods',
};

const duplicate = ({ label }: Labelled, def: string): ProblemReport => ({
  code: 'duplicate-def',
  severity: 'warning',
  attribute: 'DEF',
  value: def,
  used: 'the later element',
  message: `${label} shares its DEF with a later element, and a USE means the later one`,
});

function misplacedChild({ element, type, label }: Labelled, child: Element): ProblemReport {
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
        message: `<${child.localName}> can't stand in ${label}${cureOf(type, lowerName(child))}`,
      };
}

const undrawn: Faults['undrawn'] = ({ label }, { localName: tag }) => ({
  code: 'misplaced',
  severity: 'warning',
  value: tag,
  used: 'its bodies, unseen',
  message: `nothing draws <${tag}> in ${label}: put it after the end tag of the collection, which takes default to be the world of bodies outside (HTML knows no self-closing tags)`,
});

function cureOf({ name }: NodeType, child: string): string {
  if (child === 'shape') return '; put it into a CollidableShape, or both into a Transform';
  if (child === 'transform' && name === 'RigidBody') return '; put the body into the Transform';
  return '';
}

/** X3D wants the tag of a USE to be that of its DEF. */
function otherTag({ label }: Labelled, child: Element, { localName }: Element): ProblemReport {
  const name = show(attribute(child, 'USE'));
  return {
    code: 'misplaced',
    severity: 'warning',
    attribute: 'USE',
    value: child.localName,
    used: 'nothing',
    message: `<${child.localName} USE="${name}"> in ${label} has another tag than what it means; write <${localName} USE="${name}">`,
  };
}

function circle(use: Element): ProblemReport {
  const name = attribute(use, 'USE');
  return {
    code: 'use-circle',
    severity: 'warning',
    attribute: 'USE',
    value: name,
    used: 'nothing',
    message: `<${use.localName} USE="${show(name)}"> stands in what it means, and would go on without end`,
  };
}

const nested: Faults['nested'] = ({ label }, found, role) => ({
  code: 'use-circle',
  severity: 'warning',
  attribute: role,
  value: found.name,
  used: 'nothing',
  message: `${found.label} stands in itself: ${label} goes without it`,
});

const owned: Faults['owned'] = ({ label, type }, owner, other, role) => ({
  code: 'already-owned',
  severity: 'warning',
  attribute: role,
  value: role === 'USE' ? label : other,
  used: owner,
  message: `${label} belongs to ${owner ?? `another ${type.name}`}; ${other} goes without it`,
});

const rival: Faults['rival'] = ({ label }, element, other, role) => {
  const name = nameOf(element);
  const what = `<${element.localName}>${name ? ` "${name}"` : ''}`;
  return {
    code: 'already-owned',
    severity: 'warning',
    attribute: role,
    value: what,
    used: other,
    message: `two bodies stand for ${what}: ${other} moves it, ${label} waits until that has gone`,
  };
};

const namedCollidables: Faults['namedCollidables'] = ({ label }, text) => ({
  code: 'bad-value',
  severity: 'warning',
  attribute: 'collidables',
  value: text,
  used: 'its children',
  message: `${label}: collidables="${show(text)}" is not "*"; its children are used, which may be there by USE`,
});

const unmoved: Faults['unmoved'] = ({ label }, body) => ({
  code: 'misplaced',
  severity: 'warning',
  value: body,
  used: 'the place where it stands now',
  message: `${label} stands in a Transform that ${body} moves, and does not move with it: name it in the body's geometry`,
});

const unused: Faults['unused'] = ({ label }, isCollidable) => ({
  code: 'unused-collidable',
  severity: 'info',
  used: 'no collision',
  message: `${label} is in ${isCollidable ? 'no RigidBody and ' : ''}no CollisionCollection, and collides with nothing`,
});

const malformed: Faults['malformed'] = ({ localName: tag }, name, text) => ({
  code: 'bad-value',
  severity: 'warning',
  attribute: name,
  value: text,
  message: `<${tag}> ${name}="${show(text)}" can't be read; X3D's default is used`,
});

const OTHER_PHYSICS: ProblemReport = {
  code: 'two-physics-engines',
  severity: 'warning',
  value: 'RigidBodyPhysics of x3dom',
  used: 'x3d-physics',
  message:
    "x3dom's own physics ran before x3d-physics was loaded, and is stopped: bodies go on from where it left them, and what it lets people drag stays so; load x3d-physics with the page",
};

const refusedRoute: Faults['refusedRoute'] = ({ label, type }, name, verb) => {
  const field = type.fields[name];
  return {
    code: field ? 'bad-access' : 'unknown-attribute',
    severity: 'warning',
    attribute: name,
    value: 'ROUTE',
    used: 'nothing',
    message: field
      ? `${label}: ${name} is ${field.access} and can't be ROUTEd ${verb}`
      : `${label} has no field ${name} to ROUTE ${verb}`,
  };
};

const TWO_COPIES: ProblemReport = {
  code: 'two-copies',
  severity: 'warning',
  used: 'the first copy',
  message:
    'x3d-physics is in this page twice, say as a module and as a classic script; the first copy does all the work, the second only costs its bytes',
};

const outside: Faults['outside'] = ({ localName: tag }, inShadow) =>
  inShadow
    ? {
        code: 'shadow-root',
        severity: 'warning',
        used: 'nothing',
        message: `<${tag}> stands in a shadow root, where x3dom does not look`,
      }
    : {
        code: 'misplaced',
        severity: 'warning',
        used: 'nothing',
        message: `<${tag}> stands outside the scene of any <x3d>`,
      };

const swallowed: Faults['swallowed'] = ({ localName: tag }, { localName: child }) => ({
  code: 'self-closing',
  severity: 'error',
  value: child,
  used: 'the markup as HTML reads it',
  message: `<${tag}> has swallowed <${child}>, and nothing draws it: HTML knows no self-closing tags, write <${tag}></${tag}>`,
});

const late: Faults['late'] = (waits) => ({
  code: 'waiting-for-document',
  severity: 'warning',
  value: waits,
  message: `the simulation starts without waiting longer for ${waits}`,
});

/** With the standard's name; a plain tag that resembles none of ours is not ours to speak of. */
function stranger({ localName: tag }: Element): ProblemReport | undefined {
  const found = advice.code.meantNode(
    tag,
    [...knownTypes()].map(({ name }) => name),
  );
  const isOurs = tag.toLowerCase().startsWith('x3d-');
  if (!found && !isOurs) return undefined;
  const name = found?.type;
  const answer = name && `did you mean <${isOurs ? `x3d-${kebab(name)}` : name}>, X3D's ${name}?`;
  const text = [answer, found?.does].filter(Boolean).join(' ');
  return {
    code: 'unknown-tag',
    severity: 'warning',
    value: tag,
    used: 'nothing',
    message: `<${show(tag)}> is no node${text ? `; ${text}` : ''}`,
  };
}

function unread(inline: Element): ProblemReport {
  const value = attribute(inline, 'url');
  return {
    code: 'inline-load-failed',
    severity: 'error',
    attribute: 'url',
    value,
    used: 'nothing',
    message: `nothing of ${show(value)} is there: it can't be had, is broken, or holds no Scene`,
  };
}

const notDrawn = ({ localName: tag }: Element): ProblemReport => ({
  code: 'not-drawn',
  severity: 'warning',
  value: tag,
  used: 'its collision alone',
  message: `<${tag}> collides, but nothing draws it: this x3dom has no such node`,
});
