// The words of the markup: the library's from the data that editors get with the package, x3dom's from x3dom itself.
import type { X3domWords } from '../scene/frame.js';

export interface AttributeWord {
  name: string;
  type: string;
  default: string;
  doc: string;
  values: readonly string[];
}

export interface TagWord {
  name: string;
  doc: string;
  attributes: readonly AttributeWord[];
}

interface Declaration {
  tagName: string;
  name: string;
  summary: string;
  attributes?: {
    name: string;
    fieldName?: string;
    type: { text: string };
    default?: string;
    description: string;
  }[];
}

/** `custom-elements.json` of the package. */
export interface Manifest {
  modules: { declarations: Declaration[] }[];
}

const CHOICE = /"([^"]+)"/g;

function valuesOf(type: string): string[] {
  if (/^(SFBool|boolean)$/.test(type)) return ['true', 'false'];
  return [...type.matchAll(CHOICE)].map(([, value]) => value!);
}

const named = (name: string, doc: string): AttributeWord => ({
  ...{ name, doc },
  ...{ type: 'SFString', default: '', values: [] },
});

const NAMES = [
  named('id', 'A name for this element: for= and the like refer to it.'),
  named('DEF', 'A name for this node: USE, joints and ROUTEs refer to it.'),
  named('USE', 'The name of a node that stands here once more.'),
  named('containerField', 'The field of its parent that this node stands in.'),
];

/** They are in the manifest, too, as HTML spells them. */
const NAMED = new Set(NAMES.map(({ name }) => name.toLowerCase()));

/** `X3DRigidBodyElement` stands for `RigidBody`. */
const NODE = /^X3D(\w+)Element$/;

function tagsOf({ tagName, name, summary, attributes = [] }: Declaration): TagWord[] {
  const own = attributes.filter(({ name: each }) => !NAMED.has(each));
  const words = own.map((attribute) => ({
    name:
      attribute.fieldName && !attribute.name.includes('-') ? attribute.fieldName : attribute.name,
    type: attribute.type.text,
    default: attribute.default ?? '',
    doc: attribute.description,
    values: valuesOf(attribute.type.text),
  }));
  const tag = { name: tagName, doc: summary, attributes: [...words, ...NAMES] };
  const plain = NODE.exec(name)?.[1];
  return plain ? [tag, { ...tag, name: plain }] : [tag];
}

export class Vocabulary {
  private readonly tags = new Map<string, TagWord>();

  constructor(manifest: Manifest) {
    for (const { declarations } of manifest.modules) {
      for (const tag of declarations.filter(({ tagName }) => tagName).flatMap(tagsOf))
        this.add(tag);
    }
  }

  /** What x3dom knows, once its page is there. */
  addX3dom({ nodes }: X3domWords): void {
    for (const [name, fields] of [...nodes, ['X3D', []] as X3domWords['nodes'][number]]) {
      if (!this.tags.has(name.toLowerCase())) this.add(x3domTag(name, fields));
    }
  }

  private add(tag: TagWord): void {
    this.tags.set(tag.name.toLowerCase(), tag);
  }

  tag(name: string): TagWord | undefined {
    return this.tags.get(name.toLowerCase());
  }

  attribute(tag: string, name: string): AttributeWord | undefined {
    const key = name.toLowerCase();
    return this.tag(tag)?.attributes.find((word) => word.name.toLowerCase() === key);
  }

  get all(): TagWord[] {
    return [...this.tags.values()];
  }

  /** In lower case. */
  get names(): string[] {
    return [...this.tags.keys()];
  }
}

const x3domTag = (name: string, fields: X3domWords['nodes'][number][1]): TagWord => ({
  name,
  doc: `${name}, a node of X3DOM.`,
  attributes: [
    ...fields.map(([field, value]) => ({
      ...named(field, 'Of X3DOM.'),
      default: value,
      values: /^(true|false)$/.test(value) ? ['true', 'false'] : [],
    })),
    ...NAMES,
  ],
});
