// What of a text is not shown. A text may come from a shared address, so it must not be able to run code: only tags and
// attributes that draw and move a scene, or say a word beside it, get into the page. The page around the scene forbids
// scripts once more (scene/frame.ts).
import { isElement, type Attribute, type ElementNode, type Place, type TreeNode } from './tree.js';

export interface LeftOut extends Place {
  message: string;
}

/** Words beside a scene. */
const PROSE =
  'a b br code dd div dl dt em figcaption figure footer h1 h2 h3 h4 h5 h6 header hr i kbd li main nav ol p pre s section small span strong sub sup table tbody td th thead tr u ul';

/** Statements of X3D, which are no nodes; and what stands around a scene. */
const X3D =
  'x3d scene route unit import export component field fieldvalue is connect protodeclare protointerface protobody protoinstance externprotodeclare';

/** A word beside a scene, and no part of it. */
export const isProse = (node: TreeNode): boolean =>
  !isElement(node) || WORDS.has(node.tag.toLowerCase());

const WORDS = new Set(PROSE.split(' '));
const ALWAYS = new Set(`${PROSE} ${X3D}`.split(' '));

/** Tags whose places mean nothing in a scene's page: what stands in them counts. */
const AROUND = /^(html|body)$/i;
/** What a page says about itself. */
const ABOUT = /^(head|meta|title|link|template)$/i;

export function clean(
  roots: readonly TreeNode[],
  tags: ReadonlySet<string>,
): { roots: TreeNode[]; leftOut: LeftOut[] } {
  const leftOut: LeftOut[] = [];

  const cleanAll = (nodes: readonly TreeNode[]): TreeNode[] => nodes.flatMap(cleanNode);

  function cleanNode(node: TreeNode): TreeNode[] {
    if (!isElement(node)) return [node];
    if (AROUND.test(node.tag)) return cleanAll(node.children);
    if (ABOUT.test(node.tag)) return [];
    const message = reasonAgainst(node.tag.toLowerCase(), tags);
    if (!message)
      return [{ ...node, attributes: cleanAttributes(node), children: cleanAll(node.children) }];
    leftOut.push({ from: node.from, to: node.to, message });
    return [];
  }

  function cleanAttributes({ tag, attributes }: ElementNode): Map<string, Attribute> {
    return new Map(
      [...attributes].filter(([key, attribute]) => {
        if (isSize(tag, key)) return false;
        const message = reasonAgainstAttribute(key, attribute);
        if (message) leftOut.push({ ...attribute, message: `<${tag}>: ${message}` });
        return !message;
      }),
    );
  }

  return { roots: cleanAll(roots), leftOut };
}

/** The scene takes the place that is there. */
const isSize = (tag: string, key: string): boolean =>
  tag.toLowerCase() === 'x3d' && /^(width|height)$/.test(key);

function reasonAgainst(tag: string, tags: ReadonlySet<string>): string | undefined {
  if (tag === 'script') return 'Scripts do not run in the playground: left out.';
  if (tag === 'style') return 'Style sheets are left out in the playground.';
  if (ALWAYS.has(tag) || tags.has(tag)) return undefined;
  return `<${tag}> is no tag that the playground knows: left out with all that stands in it.`;
}

const NAME = /^[a-z_][\w.:-]*$/;
const ADDRESS = /url|href|src|action|srcset|^data$/;
const WITH_SCHEME = /^[\s"'\0-\x20]*(?:javascript|vbscript|data|blob|file)\s*:/i;

function reasonAgainstAttribute(key: string, { name, value }: Attribute): string | undefined {
  if (!NAME.test(key)) return `${name} is no attribute's name: left out.`;
  if (/^on|:on/.test(key)) return `${name} would run a script: left out in the playground.`;
  if (/^(style|srcdoc)$/.test(key)) return `${name} is left out in the playground.`;
  const isAddress = ADDRESS.test(key) || WITH_SCHEME.test(value);
  if (isAddress && !addressesIn(value).every(isHarmless)) {
    return `${name}="${value}" is left out: the playground takes addresses of http, https and of its own site.`;
  }
  return undefined;
}

/** X3D has lists of addresses, in quotes. */
const addressesIn = (value: string): string[] => value.split(/["'\s,]+/).filter(Boolean);

/** Only an address of its own says what a relative one is. */
const SOMEWHERE = 'https://somewhere.invalid/';

function isHarmless(address: string): boolean {
  try {
    return /^https?:$/.test(new URL(address, SOMEWHERE).protocol) && !address.includes('\\');
  } catch {
    return false;
  }
}
