// How messages show what an author gave: short, and never `[object Object]`.

/** Longest text of a value in a message, characters. */
const MOST = 60;

/** Nodes within nodes are named by their type. */
const DEEPEST = 2;

export const cut = (text: string): string =>
  text.length > MOST ? `${text.slice(0, MOST - 1)}…` : text;

/** Any value in a message. */
export const show = (value: unknown): string => cut(words(value, 0));

/** What is used instead, where that may be nothing at all. */
export const showUsed = (value: unknown): string =>
  value === undefined || value === null || show(value) === '' || show(value) === '[]'
    ? 'nothing'
    : show(value);

function words(value: unknown, depth: number): string {
  if (typeof value === 'function') return 'a function';
  if (value === null || typeof value !== 'object') return String(value);
  if (Array.isArray(value) || ArrayBuffer.isView(value)) return list(value, depth);
  if ('label' in value && typeof value.label === 'string') return value.label;
  const prototype: unknown = Object.getPrototypeOf(value);
  if (prototype === Object.prototype || prototype === null) return plain(value, depth);
  return `a ${value.constructor.name}`;
}

/** Numbers as X3D writes them; of a long list only what could be seen. */
function list(value: ArrayLike<unknown> | ArrayBufferView, depth: number): string {
  const items = Array.prototype.slice.call(value, 0, MOST) as unknown[];
  if (items.length === 0) return '[]';
  if (depth > DEEPEST) return '[…]';
  const apart = items.every((item) => typeof item === 'number') ? ' ' : ', ';
  return items.map((item) => words(item, depth + 1)).join(apart);
}

function plain(value: object, depth: number): string {
  if (depth >= DEEPEST) return 'type' in value ? `{ type: ${words(value.type, depth)}, … }` : '{…}';
  const fields = Object.entries(value)
    .slice(0, MOST)
    .map(([name, one]) => `${name}: ${words(one, depth + 1)}`);
  return fields.length === 0 ? '{}' : `{ ${fields.join(', ')} }`;
}
