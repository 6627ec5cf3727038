import type { FieldType, Value } from '../../fields/types.js';
import { quaternionOf } from '../../base/math.js';
import { show } from '../../base/show.js';
import type { FieldOwner } from './field-owner.js';
import type { Field } from './table.js';

/** Nobody sees a millimetre, or a thousandth of a radian: what lies on the ground sinks in by some tenths of one. */
const SEEN = 1e-3;

/** Of what single precision makes of large numbers. */
const ROUNDING = 1e-6;

/** The author set again what was asked for last, which is no edit: told once where the simulation has moved on since. */
export function tellUnchanged(node: FieldOwner, name: string, field: Field, asked: Value): void {
  if (!field.instead || node.fieldState.toldUnchanged.has(name)) return;
  const instead = field.instead(node);
  const live = field.read!(node);
  if (!instead || areAlike(field.type, asked as number[], live as number[])) return;
  node.fieldState.toldUnchanged.add(name);
  node.report({
    code: 'unchanged-value',
    severity: 'info',
    attribute: name,
    value: asked,
    used: live,
    message: `${node.label}: ${name}="${show(asked)}" is what it was last set to, so nothing is done, though it is ${shortly(live)} by now; ${instead}`,
  });
}

/** A rotation has many axes and angles, and a quaternion means the same as its opposite. */
function areAlike(type: FieldType, a: number[], b: number[]): boolean {
  if (type !== 'SFRotation') return areNear(a, b);
  const [p, q] = [quaternionOf(a), quaternionOf(b)];
  const opposite = q.map((value) => -value);
  return areNear(p, q) || areNear(p, opposite);
}

const areNear = (a: readonly number[], b: readonly number[]): boolean =>
  a.every((value, i) => Math.abs(value - b[i]!) <= SEEN + ROUNDING * Math.abs(value));

const shortly = (value: Value): string =>
  show((value as number[]).map((number) => Number(number.toPrecision(4))));
