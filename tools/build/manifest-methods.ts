// What the classes of elements have beside the fields of their tables: read from their sources, with what stands above
// each member.
import { readFileSync } from 'node:fs';
import ts from 'typescript';

interface Parameter {
  name: string;
  optional?: true;
  type?: { text: string };
}

export interface ClassMember {
  kind: 'method' | 'field';
  name: string;
  description?: string;
  readonly?: true;
  type?: { text: string };
  parameters?: Parameter[];
  return?: { type: { text: string } };
}

/** What the platform calls. */
const CALLBACKS = /Callback$/;

const HIDDEN = ts.ModifierFlags.Private | ts.ModifierFlags.Protected | ts.ModifierFlags.Static;

const isShown = (member: ts.ClassElement): boolean =>
  member.name !== undefined &&
  ts.isIdentifier(member.name) &&
  !CALLBACKS.test(member.name.text) &&
  !(ts.getCombinedModifierFlags(member) & HIDDEN) &&
  !ts.getJSDocTags(member).some(({ tagName }) => tagName.text === 'internal');

function description(member: ts.ClassElement): { description?: string } {
  const [doc] = ts.getJSDocCommentsAndTags(member);
  const text = doc && ts.getTextOfJSDocComment(doc.comment);
  return text ? { description: text.replace(/\s+/g, ' ') } : {};
}

const typeOf = (type: ts.TypeNode | undefined): { type?: { text: string } } =>
  type ? { type: { text: type.getText() } } : {};

const parameter = ({ name, type, questionToken }: ts.ParameterDeclaration): Parameter => ({
  name: name.getText(),
  ...typeOf(type),
  ...(questionToken ? { optional: true as const } : {}),
});

function described(member: ts.ClassElement): ClassMember[] {
  if (!isShown(member)) return [];
  const common = { name: member.name!.getText(), ...description(member) };
  if (ts.isMethodDeclaration(member))
    return [
      {
        kind: 'method',
        ...common,
        parameters: member.parameters.map(parameter),
        ...(member.type ? { return: { type: { text: member.type.getText() } } } : {}),
      },
    ];
  if (ts.isGetAccessorDeclaration(member))
    return [{ kind: 'field', ...common, ...typeOf(member.type), readonly: true }];
  return [];
}

/** The public methods and live properties of the classes in a file. */
export function membersIn(file: string): ClassMember[] {
  const source = ts.createSourceFile(
    file,
    readFileSync(file, 'utf8'),
    ts.ScriptTarget.ES2022,
    true,
  );
  return source.statements
    .filter(ts.isClassDeclaration)
    .flatMap(({ members }) => members.flatMap(described));
}
