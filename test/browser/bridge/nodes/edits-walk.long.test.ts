import { expect } from 'chai';
import { ownBinding } from '../../../../elements/bridge/nodes/binding.js';
import {
  deformableTags,
  particleTags,
  ropeTags,
  waterTags,
} from '../../../../elements/bridge/index.js';
import { worldOf } from '../../../../elements/index.js';
import { allTypes } from '../../../../physics-core/all-types.js';
import { waveChunk } from '../../../../physics-core/effects/water/effects.js';
import { drags, meshes, threads, type Problem } from '../../../../physics-core/inside.js';
import { particleTypes } from '../../../../physics-core/particles.js';
import { deformableTypes } from '../../../../physics-core/deformables.js';
import { softTypes } from '../../../../physics-core/ropes.js';
import { waterTypes } from '../../../../physics-core/water.js';
import type { NodeData } from '../../../conformance/fact.js';
import { fieldText, markup, nodesIn, typesByName } from '../../../conformance/markup.js';
import { kebab, tags } from '../../../conformance/page-driver.js';
import { scene, SECONDS, SPARES, SUBJECTS } from '../../../edits/scene.js';
import { editOf } from '../../../edits/table.js';
import { ALL_FIELDS, walkField, type Editor } from '../../../edits/walk.js';
import { claim } from '../../console.js';
import type { World } from '../../inside.js';

interface X3DElement extends Element {
  setFieldValue(field: string, value: unknown): void;
  [property: string]: unknown;
}

/** How an author edits: by attributes or properties of our tags, or by attributes of X3D's own. */
type Way = 'attributes' | 'properties' | 'plain';

const holdsNodes = (subject: string, name: string): boolean =>
  fieldOf(subject, name).type.endsWith('Node');

const typeOf = (subject: string): string =>
  Object.entries(SUBJECTS).find(([, name]) => name === subject)![0];

const fieldOf = (subject: string, name: string) => allTypes[typeOf(subject)]!.fields[name]!;

/** Shapes of the spare geometries, and the metadata. */
const spares = (): string =>
  Object.entries(SPARES)
    .map(([DEF, data]) => markup({ ...data, DEF } as NodeData, { types: new Map(), tag: String }))
    .map((text) => (text.startsWith('<Metadata') ? text : `<Shape>${text}</Shape>`))
    .join('');

/** The scene of the walk in a page. */
class PageEditor implements Editor {
  readonly world: World;
  readonly #x3d: Element;
  readonly #way: Way;
  readonly #told: string[] = [];

  /** Among what nodes of a type are walked among. */
  constructor(way: Way, type: string) {
    const nodes = scene(type);
    const spelling = {
      types: typesByName(nodes),
      tag: way === 'plain' ? tags.plain : tags.hyphenated,
    };
    const content = nodes.map((node) => markup(node, spelling)).join('');
    document.body.innerHTML = `<x3d width="16px" height="16px"><scene>${spares()}${content}</scene></x3d>`;
    this.#x3d = document.body.firstElementChild!;
    this.#way = way;
    this.world = worldOf(this.element('world'))! as unknown as World;
    this.world.paused = true;
    this.world.on('problem', (problem) => this.#told.push((problem as Problem).code));
  }

  /** An edit that has code fetched would hold time still. */
  async ready(): Promise<void> {
    const code = [drags, threads, meshes, waveChunk];
    await Promise.all([this.world.ready, ...code.map((chunk) => chunk.load())]);
  }

  /** As the walk finds it. */
  begin(): void {
    this.world.reset();
    this.world.advance(SECONDS);
    this.told();
  }

  element(name: string): X3DElement {
    return this.#x3d.querySelector(`[DEF="${name}"]`)!;
  }

  hasMarkup(subject: string, name: string): boolean {
    return this.#way === 'properties' || holdsNodes(subject, name);
  }

  /** Contacts are made by sensors; what their elements say is read by page code alone. */
  keeps(subject: string, name: string): boolean {
    const { edit, nodes } = fieldOf(subject, name);
    // What particles are drawn as.
    const drawn = subject === SUBJECTS.ParticleSystem && name === 'geometry';
    return (
      subject === SUBJECTS.Contact ||
      (holdsNodes(subject, name) && edit === 'passive' && (drawn || !nodes))
    );
  }

  read(subject: string, name: string): unknown {
    const element = this.element(subject);
    const binding = ownBinding(element)!;
    const names = (value: unknown): unknown =>
      value instanceof Element ? { USE: value.getAttribute('DEF') } : value;
    const value = this.#way === 'plain' ? binding.get(name) : element[name];
    return Array.isArray(value) ? value.map(names) : names(value);
  }

  told(): string[] {
    const told = this.#told.splice(0);
    claim(...told.map((code) => `[${code}]`));
    return told;
  }

  /** Elements by name; for the Shape of a spare geometry, that one's. */
  #elements(name: string, value: unknown): unknown {
    const named = (nodesIn(value) as NodeData[] | undefined)?.map(({ USE }) => this.element(USE!));
    const found = name === 'shape' ? named?.map((each) => each.parentElement!) : named;
    return found ?? value;
  }

  set(subject: string, name: string, value: unknown): void {
    const element = this.element(subject);
    if (this.#way === 'properties') element[name] = this.#elements(name, value);
    else if (this.#isNamed(subject, name))
      this.#setNodes(element, name, this.#elements(name, value));
    else element.setAttribute(attributeOf(subject, name), fieldText(value));
  }

  /** Children stand for these in markup; script names them. */
  #isNamed(subject: string, name: string): boolean {
    return holdsNodes(subject, name) && fieldOf(subject, name).access !== 'outputOnly';
  }

  #setNodes(element: X3DElement, name: string, value: unknown): void {
    if (this.#way === 'plain') element.setFieldValue(name, value);
    else element[name] = value;
  }

  unset(subject: string, name: string): void {
    const element = this.element(subject);
    if (this.#way === 'properties') element[name] = undefined;
    else if (this.#isNamed(subject, name)) this.#setNodes(element, name, undefined);
    else element.removeAttribute(attributeOf(subject, name));
  }

  event(subject: string, name: string, value: unknown): boolean {
    if (holdsNodes(subject, name)) return false;
    this.element(subject).setFieldValue(name, value);
    return true;
  }

  /** The markup as it was. */
  restore(subject: string, before: readonly [string, string][]): void {
    const element = this.element(subject);
    for (const { name } of [...element.attributes])
      if (!before.some(([known]) => known === name)) element.removeAttribute(name);
    for (const [name, text] of before)
      if (Element.prototype.getAttribute.call(element, name) !== text)
        element.setAttribute(name, text);
  }
}

const attributeOf = (subject: string, name: string): string =>
  fieldOf(subject, name).own ? kebab(name) : name;

const attributes = (element: Element): [string, string][] =>
  [...element.attributes].map(({ name, value }) => [name, value]);

const WAYS: Record<Way, string> = {
  attributes: 'attributes of our tags',
  properties: 'properties of our tags',
  plain: 'attributes of plain tags',
};

/** What is walked in one scene. */
const GROUPS = {
  bodies: ALL_FIELDS.filter(
    ([type]) =>
      ![deformableTypes, particleTypes, softTypes, waterTypes].some((types) => type in types),
  ),
  particles: ALL_FIELDS.filter(([type]) => type in particleTypes),
  ropes: ALL_FIELDS.filter(([type]) => type in softTypes),
  cloth: ALL_FIELDS.filter(([type]) => type === 'Cloth'),
  'soft bodies': ALL_FIELDS.filter(([type]) => type === 'SoftBody'),
  water: ALL_FIELDS.filter(([type]) => type in waterTypes),
};

function walkAll(way: Way, fields: typeof ALL_FIELDS): void {
  let editor: PageEditor | undefined;

  before(async () => {
    editor = new PageEditor(way, fields[0]![0]);
    await editor.ready();
  });

  for (const [type, field] of fields)
    it(`${type}.${field}: changes what the table says, and nothing else`, () => {
      const subject = SUBJECTS[type]!;
      const markupBefore = attributes(editor!.element(subject));
      editor!.begin();
      const wrong = walkField(type, field, editor!);
      expect(wrong).to.eql([]);
      for (const given of Object.keys(editOf(type, field)?.given ?? {}))
        editor!.unset(subject, given);
      editor!.restore(subject, markupBefore);
      editor!.world.step(0);
      editor!.told();
      walked.add(`${way} ${type}.${field}`);
    });
}

const walked = new Set<string>();

// What comes late would have worlds wait for it.
await Promise.all([deformableTags.load(), particleTags.load(), ropeTags.load(), waterTags.load()]);

for (const [way, how] of Object.entries(WAYS) as [Way, string][])
  describe(`edits by ${how}`, () => {
    for (const [what, fields] of Object.entries(GROUPS))
      describe(`among ${what}`, () => walkAll(way, fields));
  });

describe('all edits', () => {
  it('are of as many fields as stand in the tables of all node types', () => {
    const all = Object.values(allTypes).flatMap(({ fields }) => Object.keys(fields));
    expect(walked.size).to.equal(all.length * Object.keys(WAYS).length);
  });
});
