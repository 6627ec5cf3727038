import { PhysicsNode } from '../../physics-core/inside.js';

/** What a fact reads: nodes as their DEF names, Contacts with all their fields. */
export function plain(value: unknown): unknown {
  if (Array.isArray(value)) return value.map(plain);
  if (!(value instanceof PhysicsNode)) return value;
  if (value.type.name !== 'Contact') return value.name ?? null;
  return Object.fromEntries(
    Object.keys(value.type.fields).map((field) => [field, plain(value.get(field))]),
  );
}
