// What a field is where its markup says nothing, as text.
import { holdsNodes } from '../../elements/bridge/words/fields.js';
import { codecs } from '../../physics-core/fields/values.js';
import type { Field } from '../../physics-core/nodes/node/table.js';

export const withPi = (text: string): string => text.replace(`${Math.PI}`, 'π');

const valueText = (field: Field, value: unknown): string => {
  if (holdsNodes(field)) return value === null ? 'NULL' : '[]';
  return withPi(codecs[field.type].format(value)) || (field.type === 'SFString' ? '""' : '[]');
};

export function defaultText(field: Field): string {
  const text = valueText(field, field.default);
  const { default3 } = field;
  return default3 === undefined ? text : `${text}; in X3D 3: ${valueText(field, default3)}`;
}
