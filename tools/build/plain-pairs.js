/** Visits each node of a syntax tree, the outer ones first. */
export function walk(node, visit) {
  if (typeof node?.type === 'string') visit(node);
  for (const child of Object.values(node)) {
    if (child && typeof child === 'object') walk(child, visit);
  }
}

/**
 * A list that is taken apart where it stands, as in `const [x, y] = [a[i], a[j]]`, reads well, and engines make an array of
 * it and walk through that until they have compiled the function for the last time; WebKit's does so even then (measured:
 * a third of what contacts take). For pages it becomes `const x = a[i], y = a[j]`. Lines stay where they are.
 */
export function plainPairs() {
  return {
    name: 'plain-pairs',
    transform(code, id) {
      return id.endsWith('.ts') ? { code: plain(code, this.parse(code)), map: null } : null;
    },
  };
}

export function plain(code, tree) {
  const edits = [];
  walk(tree, (node) => {
    const { type, id, init, expression } = node;
    if (type === 'VariableDeclarator' && isPair(code, id, init))
      edits.push(...declared(code, node));
    if (
      type === 'ExpressionStatement' &&
      expression.type === 'AssignmentExpression' &&
      isPair(code, expression.left, expression.right)
    )
      edits.push(...assigned(code, node));
  });
  return edited(code, edits);
}

/** As many names as values, each by itself. */
function isPair(code, names, values) {
  if (names?.type !== 'ArrayPattern' || values?.type !== 'ArrayExpression') return false;
  const [left, right] = [names.elements, values.elements];
  return (
    left.length === right.length &&
    left.every((each) => each?.type === 'Identifier' || each?.type === 'MemberExpression') &&
    right.every((each) => each && each.type !== 'SpreadElement') &&
    right.every((each, i) => i === 0 || /^\s*,\s*$/.test(code.slice(right[i - 1].end, each.start)))
  );
}

const textsOf = (code, nodes) => nodes.map(({ start, end }) => code.slice(start, end));

/** `[a, b] = [x, y]` of a declaration: a = x, b = y. */
function declared(code, { start, end, id, init }) {
  const names = textsOf(code, id.elements);
  return around(start, end, init.elements, (i) => `${i > 0 ? ', ' : ''}${names[i]} = `, '');
}

/** All values are there before the first name has its own: `[a, b] = [b, a]` is a swap. */
function assigned(code, { start, end, expression: { left, right } }) {
  const names = textsOf(code, left.elements);
  const gives = names.map((name, i) => `${name} = $${i};`).join(' ');
  const before = (i) => `${i > 0 ? ', ' : '{ const '}$${i} = `;
  return around(start, end, right.elements, before, `; ${gives} }`);
}

/** Other text between the values, which stay. */
function around(start, end, values, before, after) {
  const edits = values.map((value, i) => [
    i > 0 ? values[i - 1].end : start,
    value.start,
    before(i),
  ]);
  return [...edits, [values.at(-1).end, end, after]];
}

/** No two edits have anything in common. */
function edited(code, edits) {
  let text = '';
  let at = 0;
  for (const [start, end, by] of edits.sort(([a], [b]) => a - b)) {
    const lines = code.slice(start, end).replace(/[^\n]/g, '');
    text += code.slice(at, start) + by + lines;
    at = end;
  }
  return text + code.slice(at);
}
