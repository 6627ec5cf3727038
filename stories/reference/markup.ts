// A story's markup as text, in both spellings, from the template that the story renders.
import { nothing, type TemplateResult } from 'lit';
import { codecs } from '../../physics-core/fields/values.js';
import { allTypes } from '../../physics-core/all-types.js';
import { tagOf } from '../../elements/bridge/words/dom.js';

interface Element {
  tag: string;
  /** Names as the story's author wrote them; a value of null is a bare attribute. */
  attributes: [string, string | null][];
  children: Element[];
}

const isTemplate = (value: unknown): value is TemplateResult =>
  typeof value === 'object' && value !== null && 'strings' in value;

/** `nothing` takes its attribute away: a mark that no markup has. */
const ABSENT = '\u0000';

function textOf(value: unknown): string {
  if (isTemplate(value)) return flatten(value);
  if (Array.isArray(value)) return value.map(textOf).join('');
  if (value === nothing || typeof value === 'function' || typeof value === 'object') return ABSENT;
  return String(value);
}

/** An attribute that ends where its value is bound, without quotes of its own. */
const UNQUOTED = /[\w-]=$/;

function flatten({ strings, values }: TemplateResult): string {
  return strings.reduce((text, next, i) => {
    const value = textOf(values[i - 1]);
    return text + (UNQUOTED.test(text) ? quoted(value) : value) + next;
  });
}

const quoted = (value: string): string => (value.includes('"') ? `'${value}'` : `"${value}"`);

const TAG = /<(\/?)([\w-]+)((?:\s+[@.?]?[\w-]+(?:=(?:"[^"]*"|'[^']*'))?)*)\s*\/?>/g;
const ATTRIBUTE = /([@.?]?[\w-]+)(?:=(?:"([^"]*)"|'([^']*)'))?/g;

const types = new Map(Object.values(allTypes).map((type) => [tagOf(type), type]));

/** A control's value that says nothing new. */
function isDefault(tag: string, name: string, value: string | null): boolean {
  const field = types.get(tag)?.fields[name];
  if (!field || value === null) return false;
  const codec = codecs[field.type];
  const parsed = codec.parse(value);
  return parsed !== undefined && codec.equal(parsed, field.default);
}

/** `?fixed=${true}` is a bare attribute; of false there is none. */
const bound = (name: string, value: string | null): [string, string | null] =>
  name.startsWith('?') ? [name.slice(1), value === 'true' ? null : ABSENT] : [name, value];

function attributesIn(text: string, tag: string): [string, string | null][] {
  return [...text.matchAll(ATTRIBUTE)]
    .map(([, name, double, single]) => bound(name!, double ?? single ?? null))
    .filter(([name, value]) => /^\w/.test(name) && value !== ABSENT)
    .filter(([name, value]) => !isDefault(tag, name, value));
}

function parse(text: string): Element {
  const root: Element = { tag: '', attributes: [], children: [] };
  const open = [root];
  for (const [, closes, tag, attributes] of text.matchAll(TAG)) {
    if (closes) {
      open.pop();
      continue;
    }
    const element = { tag: tag!, attributes: attributesIn(attributes!, tag!), children: [] };
    open.at(-1)!.children.push(element);
    open.push(element);
  }
  return root;
}

interface Spelling {
  tag(tag: string): string;
  attribute(name: string, value: string | null): string;
  empty(start: string, tag: string): string;
}

const custom: Spelling = {
  tag: (tag) => tag,
  attribute: (name, value) => (value === null ? name : `${name}=${quoted(value)}`),
  empty: (start, tag) => `<${start}></${tag}>`,
};

/** X3D's names of the nodes that stories draw with. */
const DRAWN =
  'Appearance Box ColorRGBA Cone Coordinate Cylinder Group IndexedFaceSet IndexedLineSet Material PixelTexture Shape Sphere Switch TextureProperties TextureTransform Transform';

const NAMES = new Map([
  ...DRAWN.split(' ').map((name) => [name.toLowerCase(), name] as const),
  ...[...types].map(([tag, type]) => [tag, type.name] as const),
]);
const ATTRIBUTES: Record<string, string> = {
  id: 'DEF',
  def: 'DEF',
  use: 'USE',
  containerfield: 'containerField',
};

const plain: Spelling = {
  tag: (tag) => NAMES.get(tag) ?? tag,
  attribute: (name, value) => `${ATTRIBUTES[name] ?? name}=${quoted(value ?? 'true')}`,
  empty: (start) => `<${start}/>`,
};

/** Longer tags have an attribute a line. */
const WIDTH = 90;

function print(element: Element, spelling: Spelling, indent = ''): string {
  const tag = spelling.tag(element.tag);
  const attributes = element.attributes.map(([name, value]) => spelling.attribute(name, value));
  const line = [tag, ...attributes].join(' ');
  const start = line.length > WIDTH ? [tag, ...attributes].join(`\n${indent}    `) : line;
  if (element.children.length === 0) return indent + spelling.empty(start, tag);
  const inner = element.children.map((child) => print(child, spelling, `${indent}  `));
  return [`${indent}<${start}>`, ...inner, `${indent}</${tag}>`].join('\n');
}

function find(element: Element, tag: string): Element | undefined {
  if (element.tag === tag) return element;
  for (const child of element.children) {
    const found = find(child, tag);
    if (found) return found;
  }
  return undefined;
}

/** Camera and lights: every story has the same. */
const STAGE = /^(viewpoint|background|navigationinfo|directionallight)$/;

/** What a story has in its `<scene>`, as custom tags in HTML and as X3D's own in XML. */
export function markupOf(story: TemplateResult): { custom: string; plain: string } {
  const scene = find(parse(flatten(story)), 'scene');
  const content = scene?.children.filter(({ tag }) => !STAGE.test(tag)) ?? [];
  const text = (spelling: Spelling) => content.map((child) => print(child, spelling)).join('\n');
  return { custom: text(custom), plain: text(plain) };
}

/** All of a story's `<x3d>`, camera and lights included, in HTML; undefined where it has none. */
export function sceneOf(story: TemplateResult): string | undefined {
  const x3d = find(parse(flatten(story)), 'x3d');
  return x3d && print(x3d, custom);
}
