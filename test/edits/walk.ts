import { allTypes } from '../../physics-core/all-types.js';
import type { Field, World } from '../../physics-core/inside.js';
import type { Edit } from './edit.js';
import { SUBJECTS } from './scene.js';
import { differences, itemOf, stateOf, type State } from './state.js';
import { editOf } from './table.js';

/** The scene of the walk, running and paused, and a way to edit it. Nodes in values are named, as in `use('name')`. */
export interface Editor {
  readonly world: World;
  /** Un-authored it has what the markup says, where that says something: by other attributes, by child elements. */
  hasMarkup(subject: string, field: string): boolean;
  /** No node of the core has the field: the page alone keeps it. */
  keeps(subject: string, field: string): boolean;
  /** As page code reads it, nodes by their names. */
  read(subject: string, field: string): unknown;
  /** Codes of the problems told since the last call. */
  told(): string[];
  set(subject: string, field: string, value: unknown): void;
  unset(subject: string, field: string): void;
  /** An X3D event; false where there is no way to send one. */
  event(subject: string, field: string, value: unknown): boolean;
}

/** What may differ when an edit has been taken back: which object it is, and contacts that the next step finds again. */
const AFRESH = ['~object', '*~object', '~shape', '*~shape', '@touching'];

const pattern = (item: string): RegExp =>
  new RegExp(`^${item.replace('?', '').replace(/\./g, '\\.').replace(/\*/g, '[^.~@]+')}$`);

interface Expected {
  made: number;
  /** As many as are made, unless it says otherwise. */
  ended?: number;
  patched: number;
  /** Items that must differ (after `?`: may), and those that may. */
  differ?: readonly string[];
  may?: readonly string[];
}

const NOTHING: Expected = { made: 0, patched: 0, differ: [] };

/** Edits one field step by step and notes what is not as it should be. */
class Walk {
  readonly wrong: string[] = [];
  readonly #editor: Editor;
  readonly #subject: string;
  readonly #name: string;
  readonly #field: Field;
  #counts: number[];

  constructor(editor: Editor, type: string, name: string) {
    this.#editor = editor;
    this.#subject = SUBJECTS[type]!;
    this.#name = name;
    this.#field = allTypes[type]!.fields[name]!;
    this.#counts = this.#countsNow();
  }

  // ---- the walk -------------------------------------------------------------------------------------------------

  input(edit: Edit): void {
    const { values, changes = [], stays = [], tells = [], ends = [] } = edit;
    const rebuild = this.#field.edit === 'rebuild';
    const once = { made: rebuild ? 1 : 0, patched: rebuild ? 0 : 1 };
    const takes = this.#field.access === 'inputOnly';
    const all = takes ? changes : [`.${this.#name}`, ...changes];
    for (const [given, value] of Object.entries(edit.given ?? {}))
      this.#editor.set(this.#subject, given, value);
    const ended = hearEnds(this.#editor.world);
    this.#begin();

    const before = this.#look();
    this.#set(values[0]);
    const first = this.#judge('a value', before, { ...once, differ: all });
    this.#told('a value', tells);
    if (!takes) {
      this.#set(values[0]);
      this.#judge('the equal value', first, NOTHING);
    }
    this.#set(values[1]);
    const second = this.#judge('another value', first, { ...once, may: [...all, ...stays] });
    this.#told('another value', [], tells);
    this.#event(values[1], second, once);
    const may = [...AFRESH, ...stays];
    if (!takes && edit.vanishes && !this.#hasMarkup) this.#vanish(second, may);
    else if (!takes) this.#takeBack(before, second, { ...once, may });
    this.#told('all of it', [], [...tells, ...ends]);
    this.#end(ended, edit);
  }

  /** Known to the page alone. */
  kept({ values }: Edit): void {
    const before = this.#look();
    const initial = this.#field.default;
    for (const value of [...values, undefined]) {
      if (value === undefined) this.#unset();
      else this.#set(value);
      this.#judge('a value', before, NOTHING);
      const read = JSON.stringify(this.#editor.read(this.#subject, this.#name));
      const wanted = JSON.stringify(value ?? initial);
      if (read !== wanted) this.wrong.push(`it reads ${read}, not ${wanted}`);
    }
    this.#told('all of it', []);
  }

  /** Nobody's to set. */
  output(): void {
    const before = this.#look();
    this.#set(this.#field.default);
    this.#judge('a value', before, NOTHING);
    this.#told('a value', ['bad-access']);
    this.#unset();
    this.#judge('the default', before, NOTHING);
  }

  /** An event acts even where its value is the one last asked for; initializeOnly fields take none. */
  #event(value: unknown, since: State, once: Expected): void {
    if (!this.#editor.event(this.#subject, this.#name, value)) return;
    const refused = this.#field.access === 'initializeOnly';
    this.#judge('an event', since, refused ? NOTHING : { ...once, may: AFRESH });
    if (refused) this.#told('an event', ['bad-access']);
  }

  #vanish(since: State, may: readonly string[]): void {
    this.#unset();
    this.#judge('nothing', since, { made: 0, ended: 1, patched: 0, may });
  }

  #takeBack(before: State, since: State, expected: Expected): void {
    const item = `${this.#subject}.${this.#name}`;
    const initial = itemOf(this.#field, this.#field.default);
    const last = since.get(item);
    // The markup may say just what was asked for last.
    const same = this.#hasMarkup && last === before.get(item) && last !== initial;
    this.#unset();
    const may = { ...expected, ...(same ? NOTHING : {}), differ: [] };
    const back = this.#judge('the default', before, may);
    const value = back.get(item);
    if (value !== initial && !this.#isMarkup(value, before.get(item), expected.may))
      this.wrong.push(`the default: it is ${value}`);
    this.#unset();
    this.#judge('the default again', back, NOTHING);
  }

  /** Where the simulation has moved on from what the scene says, it stays different. */
  #isMarkup(value: unknown, before: unknown, stays: readonly string[] = []): boolean {
    return this.#hasMarkup && (value === before || stays.includes(`.${this.#name}`));
  }

  #end(ended: readonly string[], { parts }: Edit): void {
    this.#editor.world.step(2);
    if (ended.length > 0 && !parts) this.wrong.push(`contacts of ${ended.join()} end`);
    if (ended.length === 0 && parts && !this.#hasMarkup) this.wrong.push('no contact ends');
  }

  get #hasMarkup(): boolean {
    return this.#editor.hasMarkup(this.#subject, this.#name);
  }

  // ---- looking --------------------------------------------------------------------------------------------------

  #set(value: unknown): void {
    this.#editor.set(this.#subject, this.#name, value);
  }

  #unset(): void {
    this.#editor.unset(this.#subject, this.#name);
  }

  #begin(): void {
    this.#counts = this.#countsNow();
    this.#editor.told();
  }

  #look(): State {
    return stateOf(this.#editor.world);
  }

  #countsNow(): number[] {
    this.#editor.world.step(0);
    const { created, destroyed, patched } = this.#editor.world.stats;
    return [created, destroyed, patched];
  }

  /** What the last edit did, against the state `since`. */
  #judge(
    what: string,
    since: State,
    { made, ended = made, patched, differ = [], may = [] }: Expected,
  ): State {
    const now = this.#look();
    const before = this.#counts;
    this.#counts = this.#countsNow();
    const counts = this.#counts.map((count, i) => count - before[i]!).join();
    const wanted = [made, ended, patched].join();
    if (counts !== wanted)
      this.wrong.push(`${what}: created, destroyed, patched ${counts}, not ${wanted}`);
    const found = differences(since, now).map((item) => this.#own(item));
    const allowed = [...differ, ...may].map(pattern);
    const surplus = found.filter((item) => !allowed.some((each) => each.test(item)));
    if (surplus.length > 0) this.wrong.push(`${what}: changes ${surplus.join(' ')}, too`);
    const missing = differ.filter(
      (item) => !item.startsWith('?') && !found.some((each) => pattern(item).test(each)),
    );
    if (missing.length > 0) this.wrong.push(`${what}: does not change ${missing.join(' ')}`);
    return now;
  }

  #own(item: string): string {
    const { length } = this.#subject;
    return item.startsWith(this.#subject) && /[.~]/.test(item[length]!) ? item.slice(length) : item;
  }

  /** Which problems were told since the last look. */
  #told(what: string, codes: readonly string[], may: readonly string[] = []): void {
    const told = new Set(this.#editor.told());
    for (const code of codes)
      if (!told.delete(code)) this.wrong.push(`${what}: does not tell ${code}`);
    for (const code of told) if (!may.includes(code)) this.wrong.push(`${what}: tells ${code}`);
  }
}

/** What is wrong with the edits of a field; nothing, if all is well. */
export function walkField(type: string, name: string, editor: Editor): string[] {
  const edit = editOf(type, name);
  const walk = new Walk(editor, type, name);
  if (allTypes[type]!.fields[name]!.access === 'outputOnly') walk.output();
  else if (!edit) walk.wrong.push('the table has no edit for it');
  else if (editor.keeps(SUBJECTS[type]!, name)) walk.kept(edit);
  else walk.input(edit);
  return walk.wrong;
}

/** Names of the bodies whose contacts end from now on. */
function hearEnds(world: World): string[] {
  const ended: string[] = [];
  for (const node of world.nodes)
    if (node.type.name === 'RigidBody') node.on('collisionend', () => ended.push(node.name!));
  // Contacts are known from the first step on in which somebody listens.
  world.step();
  return ended;
}

/** Every field of every node type. */
export const ALL_FIELDS: readonly [type: string, field: string][] = Object.values(allTypes).flatMap(
  ({ name, fields }) => Object.keys(fields).map((field) => [name, field] as [string, string]),
);
