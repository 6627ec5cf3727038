import ts from 'typescript';

/** A piece of text put into the source at a place. */
interface Insertion {
  at: number;
  text: string;
}

/**
 * The same TypeScript, in which every function with a body tells `globalThis.walks` when it begins and when it ends. A
 * generator and an async function, whose bodies run later, tell only that they were called.
 */
export function instrumented(source: string, file: string): string {
  const tree = ts.createSourceFile(file, source, ts.ScriptTarget.ES2022, true);
  const insertions: Insertion[] = [];
  const visit = (node: ts.Node): void => {
    const [begin, end] = isFunction(node) && node.body ? around(node, node.body, file) : [];
    if (begin) insertions.push(begin);
    ts.forEachChild(node, visit);
    // Of functions that end at one place the inner ones end first.
    if (end) insertions.push(end);
  };
  visit(tree);
  return applied(source, insertions);
}

type Recorded =
  | ts.MethodDeclaration
  | ts.AccessorDeclaration
  | ts.ConstructorDeclaration
  | ts.FunctionDeclaration
  | ts.FunctionExpression
  | ts.ArrowFunction;

const isFunction = (node: ts.Node): node is Recorded => ts.isFunctionLike(node) && 'body' in node;

function around(node: Recorded, body: ts.Node, file: string): [Insertion, Insertion] {
  const enter = `globalThis.walks.enter(${JSON.stringify(file)}, ${JSON.stringify(nameOf(node))}${own(node)})`;
  const exit = 'globalThis.walks.exit()';
  const [from, to] = [body.getStart(), body.getEnd()];
  const [begin, end] = runsLater(node)
    ? [`${enter}; ${exit};`, '']
    : [`${enter}; try {`, `} finally { ${exit}; }`];
  return ts.isBlock(body)
    ? [
        { at: from + 1, text: begin },
        { at: to - 1, text: end },
      ]
    : [
        { at: from, text: `{ ${begin} return (` },
        { at: to, text: `); ${end} }` },
      ];
}

const runsLater = (node: Recorded): boolean =>
  ('asteriskToken' in node && node.asteriskToken !== undefined) ||
  (ts.canHaveModifiers(node) &&
    ts.getModifiers(node)?.some(({ kind }) => kind === ts.SyntaxKind.AsyncKeyword) === true);

/** On what a method was called, and with what. An arrow has neither, nor has an unfinished object. */
const own = (node: Recorded): string =>
  ts.isArrowFunction(node) || ts.isConstructorDeclaration(node) ? '' : ', this, arguments';

/** As people call it: `Flight.need`, `BodyNode.get movable`, `massOf`. */
function nameOf(node: Recorded): string {
  if (ts.isConstructorDeclaration(node)) return `new ${classOf(node)}`;
  if (ts.isGetAccessor(node)) return `${classOf(node)}.get ${node.name.getText()}`;
  if (ts.isSetAccessor(node)) return `${classOf(node)}.set ${node.name.getText()}`;
  if (ts.isMethodDeclaration(node)) return `${classOf(node)}.${node.name.getText()}`;
  if (node.name) return node.name.getText();
  const { parent } = node;
  if (ts.isPropertyDeclaration(parent)) return `${classOf(parent)}.${parent.name.getText()}`;
  if (ts.isVariableDeclaration(parent) || ts.isPropertyAssignment(parent))
    return parent.name.getText();
  return '=>';
}

/** Of a member of a class; an object's methods have none. */
function classOf({ parent }: ts.Node): string {
  return ts.isClassLike(parent) ? (parent.name?.getText() ?? 'class') : 'object';
}

function applied(source: string, insertions: Insertion[]): string {
  let result = '';
  let from = 0;
  for (const { at, text } of insertions.toSorted((a, b) => a.at - b.at)) {
    result += source.slice(from, at) + text;
    from = at;
  }
  return result + source.slice(from);
}
