import { codecs } from '../fields/values.js';
import type { Value } from '../fields/types.js';
import { guards } from '../guards.js';
import type { PhysicsNode } from './node.js';
import type { Field } from './table.js';

/** The field of this name; undefined after a report. */
export function fieldOf(node: PhysicsNode, name: string): Field | undefined {
  const field = node.type.fields[name] as Field | undefined;
  if (!field) {
    node.report({
      code: 'unknown-attribute',
      severity: 'warning',
      attribute: name,
      message: `${node.label} has no field ${name}`,
    });
  }
  return field;
}

/** The same, for a field that may be set. */
export function writable(node: PhysicsNode, name: string): Field | undefined {
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

export function takesEvents(node: PhysicsNode, name: string, field: Field): boolean {
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
  node: PhysicsNode,
  name: string,
  field: Field,
  value: unknown,
  text: unknown,
): Value | undefined {
  const accepted = guards.wellFormed(codecs[field.type], value);
  const named = field.values?.includes(accepted as string) ?? true;
  if (accepted !== undefined && named) return inRange(node, name, field, accepted, text);
  const used = node.asked(name);
  const expected = field.values ? field.values.join(', ') : field.type;
  node.report({
    code: 'bad-value',
    severity: 'warning',
    attribute: name,
    value: text,
    used,
    message: `${node.label}: ${name}="${show(text)}" is not ${expected}; ${show(used)} is used`,
  });
  return undefined;
}

/** Clamped where the range is closed at both ends; undefined where the last valid value stays. */
function inRange(
  node: PhysicsNode,
  name: string,
  field: Field,
  value: Value,
  text: unknown,
): Value | undefined {
  if (guards.inRange(field, value)) {
    node.world.settle(node, name);
    return value;
  }
  const [low, high] = field.range!;
  const clamp = (number: number): number => Math.min(high, Math.max(low, number));
  const clamped = Array.isArray(value) ? value.map(clamp) : clamp(value as number);
  const kept = Number.isFinite(low) && Number.isFinite(high) ? clamped : undefined;
  const used = kept ?? node.asked(name);
  node.report({
    code: 'out-of-range',
    severity: 'warning',
    attribute: name,
    value: text,
    used,
    message: `${node.label}: ${name}="${show(text)}" is outside ${field.open ? '(' : '['}${low}, ${high}]; ${show(used)} is used`,
  });
  return kept;
}

/** A value in a message: short. */
function show(value: unknown): string {
  const text = Array.isArray(value) ? value.flat().join(' ') : String(value);
  return text.length > 60 ? `${text.slice(0, 57)}…` : text;
}
