// What of a text is not shown: only tags and attributes that draw and move a scene, say a word beside it, ask for one, or
// are a script get into the page. That page is in a sandbox (scene/frame.ts), since a text may come from a shared address.
import { isScript } from './scripts.js';
import { isElement, type Attribute, type ElementNode, type Place, type TreeNode } from './tree.js';

export interface LeftOut extends Place {
  message: string;
}

/** Words beside a scene, what one presses and chooses there, and what these do. */
const PROSE =
  'a b br button code dd div dl dt em fieldset figcaption figure footer h1 h2 h3 h4 h5 h6 header hr i input kbd label legend li main meter nav ol optgroup option output p pre progress s script section select small span strong style sub sup table tbody td template textarea th thead tr u ul';

/** Statements of X3D, which are no nodes; and what stands around a scene. */
const X3D =
  'x3d scene route unit import export component field fieldvalue is connect protodeclare protointerface protobody protoinstance externprotodeclare';

/** What x3dom may lack and the library draws. */
const DRAWN =
  'elevationgrid extrusion trianglefanset trianglestripset quadset indexedtrianglefanset indexedtrianglestripset indexedquadset rectangle2d disk2d';

/** A word beside a scene, and no part of it. */
export const isProse = (node: TreeNode): boolean =>
  !isElement(node) || WORDS.has(node.tag.toLowerCase());

const WORDS = new Set(PROSE.split(' '));
const ALWAYS = new Set(`${PROSE} ${X3D} ${DRAWN}`.split(' '));

/** Tags whose places mean nothing in a scene's page: what stands in them counts. */
const AROUND = /^(html|head|body)$/i;
/** What a page says about itself. */
const ABOUT = /^(meta|title|link)$/i;
/** Scripts that every page has, and this one: x3dom, the library, and where modules find it. */
const OF_PAGE = /(^|\/)(x3dom|x3d-physics)[\w.-]*\.js$/;

function isOfPage(node: ElementNode): boolean {
  if (!isScript(node)) return ABOUT.test(node.tag);
  const valueOf = (key: string): string => node.attributes.get(key)?.value ?? '';
  return OF_PAGE.test(valueOf('src')) || valueOf('type') === 'importmap';
}

export function clean(
  roots: readonly TreeNode[],
  tags: ReadonlySet<string>,
): { roots: TreeNode[]; leftOut: LeftOut[] } {
  const leftOut: LeftOut[] = [];

  const cleanAll = (nodes: readonly TreeNode[]): TreeNode[] => nodes.flatMap(cleanNode);

  function cleanNode(node: TreeNode): TreeNode[] {
    if (!isElement(node)) return [node];
    if (AROUND.test(node.tag)) return cleanAll(node.children);
    if (isOfPage(node)) return [];
    const message = reasonAgainst(node, tags);
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

function reasonAgainst(node: ElementNode, tags: ReadonlySet<string>): string | undefined {
  const tag = node.tag.toLowerCase();
  if (isScript(node) && node.attributes.has('url'))
    return 'X3DOM runs no Script nodes of X3D: left out. A <script> of HTML beside the scene does run.';
  if (ALWAYS.has(tag) || tags.has(tag)) return undefined;
  return `<${tag}> is no tag that the playground knows: left out with all that stands in it.`;
}

const NAME = /^[a-z_][\w.:-]*$/;
const ADDRESS = /url|href|src|action|srcset|^data$/;
const WITH_SCHEME = /^[\s"'\0-\x20]*(?:javascript|vbscript|data|blob|file)\s*:/i;

function reasonAgainstAttribute(key: string, { name, value }: Attribute): string | undefined {
  if (!NAME.test(key)) return `${name} is no attribute's name: left out.`;
  if (/^on|:on/.test(key))
    return `${name} is left out in the playground: listen by addEventListener in a <script>.`;
  if (key === 'srcdoc') return `${name} is left out in the playground.`;
  const isAddress = ADDRESS.test(key) || WITH_SCHEME.test(value);
  if (isAddress && !addressesIn(value).every((address) => isHarmless(key, address))) {
    return `${name}="${shortened(value)}" is left out: the playground takes addresses of http, https and of its own site, and pictures and glTF models as data.`;
  }
  return undefined;
}

const shortened = (value: string): string =>
  value.length > 60 ? `${value.slice(0, 60)} …` : value;

/** X3D has lists of addresses, in quotes. */
const addressesIn = (value: string): string[] => value.split(/["'\s,]+/).filter(Boolean);

/** Only an address of its own says what a relative one is. */
const SOMEWHERE = 'https://somewhere.invalid/';

/** Nothing in it runs. */
const DATA = /^data:(?:image\/|model\/gltf)/i;

function isHarmless(key: string, address: string): boolean {
  if (DATA.test(address)) return /url|src/.test(key);
  try {
    return /^https?:$/.test(new URL(address, SOMEWHERE).protocol) && !address.includes('\\');
  } catch {
    return false;
  }
}
