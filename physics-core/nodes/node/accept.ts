import { codecs } from '../../fields/values.js';
import type { Value } from '../../fields/types.js';
import { boundOf, shownBound } from '../../fields/bounds.js';
import { guards } from '../../base/guards.js';
import type { ProblemReport } from '../../base/problems.js';
import { cut, show, showUsed } from '../../base/show.js';
import { meant } from './advice.js';
import type { FieldOwner } from './field-owner.js';
import type { Field } from './table.js';

/** The field of this name; undefined after a report. */
export function fieldOf(node: FieldOwner, name: string): Field | undefined {
  const field = node.type.fields[name];
  if (!field) {
    node.report({
      code: 'unknown-attribute',
      severity: 'warning',
      attribute: name,
      used: 'nothing',
      message: `${node.label} has no field ${show(name)}${meant({ name, type: node.type.name }, Object.keys(node.type.fields))}`,
    });
  }
  return field;
}

/** The same, for a field that may be set. */
export function writable(node: FieldOwner, name: string): Field | undefined {
  const field = fieldOf(node, name);
  if (field?.access !== 'outputOnly') return field;
  node.report({
    code: 'bad-access',
    severity: 'warning',
    attribute: name,
    message: `${node.label}: ${name} is an output and can't be set`,
  });
  return undefined;
}

export function takesEvents(node: FieldOwner, name: string, field: Field): boolean {
  if (field.access !== 'initializeOnly') return true;
  node.report({
    code: 'bad-access',
    severity: 'warning',
    attribute: name,
    used: node.asked(name),
    message: `${node.label}: ${name} is initializeOnly and takes no events; edit the attribute instead`,
  });
  return false;
}

/**
 * A value for a field as it may be used, or undefined after a report: what is malformed never reaches Bullet. `text`:
 * how the author wrote it.
 */
export function accept(
  node: FieldOwner,
  name: string,
  field: Field,
  value: unknown,
  text: unknown,
): Value | undefined {
  const accepted = guards.wellFormed(codecs[field.type], value);
  const refuse = refusal(node, name, text);
  if (accepted === undefined || !isNamed(field, accepted))
    return refuse('bad-value', `is not ${expected(field)}`);
  const most = boundOf(field);
  if (!guards.bounded(numbersOf(accepted), most))
    return refuse('out-of-range', `is beyond ±${shownBound(most)}, the most that it may be`);
  if (!guards.inRange(field, accepted)) return outside(field, accepted, refuse);
  if (field.least && !guards.massive(accepted as number, field.least))
    return refuse('out-of-range', `is below ${field.least}, the least that it may be above 0`);
  if (node.fieldState.refused.delete(name)) node.settle(name);
  return accepted;
}

/** Reports a value; `nearest` is used in its place, or else the last valid one. */
type Refuse = (code: string, why: string, nearest?: Value) => Value | undefined;

function refusal(node: FieldOwner, name: string, text: unknown): Refuse {
  return (code, why, nearest) => {
    const used = nearest ?? node.asked(name);
    const { authored, refused } = node.fieldState;
    refused.add(name);
    const implied = node.type.fields[name]!.implied && !authored.has(name);
    const instead = implied ? 'it counts as not written' : `${showUsed(used)} is used`;
    const report: ProblemReport = {
      code,
      severity: 'warning',
      attribute: name,
      value: text,
      used,
      message: `${node.label}: ${name}="${show(text)}" ${why}; ${instead}`,
    };
    node.report(report);
    return nearest;
  };
}

/** Clamped where the range is closed at both ends; undefined where the last valid value stays. */
function outside(field: Field, value: Value, refuse: Refuse): Value | undefined {
  const [low, high] = field.range!;
  const clamp = (number: number): number => Math.min(high, Math.max(low, number));
  const clamped = Array.isArray(value) ? value.map(clamp) : clamp(value as number);
  const closed = Number.isFinite(low) && Number.isFinite(high);
  const unit = closed && field.dimension?.angle ? ' radians' : '';
  const why = `is outside ${field.open ? '(' : '['}${low}, ${high}]${unit}`;
  return refuse('out-of-range', why, closed ? clamped : undefined);
}

/** Whether it is one of the words that a field takes, where it takes only some. */
function isNamed({ type, values, takesAll }: Field, value: Value): boolean {
  if (values) return values.includes(value as string);
  return type !== 'MFNode' || value !== '*' || takesAll === true;
}

/** What people leave out of a rotation. */
const ROTATION = ', axis and angle in radians';

function expected(field: Field): string {
  if (field.values) return `one of ${field.values.join(', ')}`;
  if (field.nodes) return `${field.type} of ${cut(field.nodes.join(', '))}`;
  const { type, default: some } = field;
  const many = Array.isArray(some) && type.startsWith('SF');
  return many ? `${type}: ${some.length} numbers${type === 'SFRotation' ? ROTATION : ''}` : type;
}

const numbersOf = (value: Value): number[] =>
  typeof value === 'number'
    ? [value]
    : Array.isArray(value)
      ? value.flat().filter((item) => typeof item === 'number')
      : [];
