import { readdirSync, readFileSync } from 'node:fs';
import { posix } from 'node:path';
import ts from 'typescript';
import { TOP, type Described } from '../rooms.config.js';
import type { Graph } from './circles.js';

/** A tree of files and what each of them imports from it. */
export interface Tree {
  root: string;
  /** Its rooms from the bottom up, the files in its root last. */
  order: string[];
  imports: Graph;
  /** Without the root. */
  short(file: string): string;
  /** Whether exactly these files may go in a circle. */
  allows(circle: string[]): boolean;
}

export function readTree({ root, rooms, circles }: Described): Tree {
  const files = readdirSync(root, { recursive: true, encoding: 'utf8' })
    .filter((name) => name.endsWith('.ts'))
    .map((name) => posix.join(root, name.replaceAll('\\', '/')))
    .sort();
  const known = new Set(files);
  const imports: Graph = new Map();
  for (const file of files) {
    const targets = modulesIn(file)
      .filter((module) => module.startsWith('.'))
      .map((module) => posix.join(posix.dirname(file), module.replace(/\.js$/, '.ts')))
      .filter((target) => known.has(target));
    imports.set(file, new Set(targets));
  }
  return {
    root,
    order: [...rooms, TOP],
    imports,
    short: (file) => file.slice(root.length + 1),
    allows: (circle) => circles.some((named) => named.toSorted().join() === circle.join()),
  };
}

/** The first folder below the root. */
export function roomOf({ root }: Tree, file: string): string {
  const [first, ...rest] = file.slice(root.length + 1).split('/');
  return rest.length > 0 ? first! : TOP;
}

/** What a file names as a module: in imports of values and types, in those at run time, and in re-exports. */
function modulesIn(file: string): string[] {
  const source = ts.createSourceFile(file, readFileSync(file, 'utf8'), ts.ScriptTarget.Latest);
  const found: string[] = [];
  const visit = (node: ts.Node): void => {
    const named = moduleNamed(node);
    if (named && ts.isStringLiteral(named)) found.push(named.text);
    ts.forEachChild(node, visit);
  };
  visit(source);
  return found;
}

function moduleNamed(node: ts.Node): ts.Node | undefined {
  if (ts.isImportDeclaration(node) || ts.isExportDeclaration(node)) return node.moduleSpecifier;
  if (ts.isImportTypeNode(node) && ts.isLiteralTypeNode(node.argument))
    return node.argument.literal;
  if (ts.isCallExpression(node) && node.expression.kind === ts.SyntaxKind.ImportKeyword)
    return node.arguments[0];
  return undefined;
}
