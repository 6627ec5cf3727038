import { nodeTypes, type Field, type World } from '../../physics-core/index.js';
import type { Edit } from './edit.js';
import { SUBJECTS } from './scene.js';
import { differences, itemOf, stateOf, type State } from './state.js';
import { editOf } from './table.js';

/** The scene of the walk, running and paused, and a way to edit it. Nodes in values are named, as in `use('name')`. */
export interface Editor {
  readonly world: World;
  /** Codes of the problems told since the last call. */
  told(): string[];
  set(subject: string, field: string, value: unknown): void;
  unset(subject: string, field: string): void;
  /** What is un-authored has what its markup says, where that says something. */
  readonly keepsMarkup?: boolean;
  /** An X3D event; not where the page has none. */
  event?(subject: string, field: string, value: unknown): void;
}

/** What may differ when an edit has been taken back: which object it is, and contacts that the next step finds again. */
const AFRESH = ['~object', '*~object', '~shape', '*~shape', '@touching'];

const pattern = (item: string): RegExp =>
  new RegExp(`^${item.replace(/\./g, '\\.').replace(/\*/g, '[^.~@]+')}$`);

interface Expected {
  made: number;
  patched: number;
  /** Items that must differ, and those that may. */
  differ?: readonly string[];
  may?: readonly string[];
}

const NOTHING: Expected = { made: 0, patched: 0, differ: [] };

/** Edits one field step by step and notes what is not as it should be. */
class Walk {
  readonly wrong: string[] = [];
  readonly #editor: Editor;
  readonly #subject: string;
  #counts: number[];

  constructor(editor: Editor, subject: string) {
    this.#editor = editor;
    this.#subject = subject;
    this.#counts = this.#countsNow();
  }

  look(): State {
    return stateOf(this.#editor.world);
  }

  #countsNow(): number[] {
    this.#editor.world.step(0);
    const { created, destroyed, patched } = this.#editor.world.stats;
    return [created, destroyed, patched];
  }

  /** What the last edit did, against the state `since`. */
  judge(what: string, since: State, { made, patched, differ, may }: Expected): State {
    const now = this.look();
    const before = this.#counts;
    this.#counts = this.#countsNow();
    const counts = this.#counts.map((count, i) => count - before[i]!).join();
    const wanted = [made, made, patched].join();
    if (counts !== wanted)
      this.wrong.push(`${what}: created, destroyed, patched ${counts}, not ${wanted}`);
    const found = differences(since, now).map((item) => this.#own(item));
    const allowed = [...(differ ?? []), ...(may ?? [])].map(pattern);
    const surplus = found.filter((item) => !allowed.some((each) => each.test(item)));
    if (surplus.length > 0) this.wrong.push(`${what}: changes ${surplus.join(' ')}, too`);
    const missing = (differ ?? []).filter(
      (item) => !found.some((each) => pattern(item).test(each)),
    );
    if (missing.length > 0) this.wrong.push(`${what}: does not change ${missing.join(' ')}`);
    return now;
  }

  #own(item: string): string {
    const { length } = this.#subject;
    return item.startsWith(this.#subject) && /[.~]/.test(item[length]!) ? item.slice(length) : item;
  }

  /** Which problems were told since the last look. */
  told(what: string, codes: readonly string[], may: readonly string[] = []): void {
    const told = new Set(this.#editor.told());
    for (const code of codes)
      if (!told.delete(code)) this.wrong.push(`${what}: does not tell ${code}`);
    for (const code of told) if (!may.includes(code)) this.wrong.push(`${what}: tells ${code}`);
  }
}

/** What is wrong with the edits of a field; nothing, if all is well. */
export function walkField(type: string, name: string, editor: Editor): string[] {
  const field = nodeTypes[type]!.fields[name]!;
  if (field.access === 'outputOnly') return walkOutput(type, name, editor);
  const edit = editOf(type, name);
  return edit ? walkInput(type, name, edit, editor) : ['the table has no edit for it'];
}

function walkInput(type: string, name: string, edit: Edit, editor: Editor): string[] {
  const subject = SUBJECTS[type]!;
  const field = nodeTypes[type]!.fields[name]!;
  const ended = hearEnds(editor.world);
  for (const [given, value] of Object.entries(edit.given ?? {})) editor.set(subject, given, value);
  const walk = new Walk(editor, subject);
  const { values, changes = [], stays = [] } = edit;
  const rebuild = field.edit === 'rebuild';
  const once = { made: rebuild ? 1 : 0, patched: rebuild ? 0 : 1 };
  const input = field.access === 'inputOnly';
  const all = input ? changes : [`.${name}`, ...changes];
  editor.told();

  const before = walk.look();
  editor.set(subject, name, values[0]);
  const first = walk.judge('a value', before, { ...once, differ: all });
  walk.told('a value', edit.tells ?? []);
  if (!input) {
    editor.set(subject, name, values[0]);
    walk.judge('the equal value', first, NOTHING);
  }
  editor.set(subject, name, values[1]);
  const second = walk.judge('another value', first, { ...once, may: [...all, ...stays] });
  walkEvent(name, field, values[1], { walk, editor, subject, second, once });
  editor.unset(subject, name);
  const back = walk.judge('the default', before, { ...once, may: [...AFRESH, ...stays] });
  const item = `${subject}.${name}`;
  const restored = editor.keepsMarkup
    ? [itemOf(field, field.default), before.get(item)]
    : [itemOf(field, field.default)];
  if (!input && !restored.includes(back.get(item)))
    walk.wrong.push(`the default: it is ${back.get(item)}`);
  editor.unset(subject, name);
  walk.judge('the default again', back, NOTHING);
  walk.told('all of it', [], edit.tells);

  editor.world.step(2);
  if (ended.length > 0 !== !!edit.parts)
    walk.wrong.push(`contacts of ${ended.join() || 'nobody'} end`);
  return walk.wrong;
}

/** An event acts even where its value is the one last asked for; initializeOnly fields take none. */
function walkEvent(
  name: string,
  field: Field,
  value: unknown,
  at: { walk: Walk; editor: Editor; subject: string; second: State; once: Expected },
): void {
  const { walk, editor, subject, second, once } = at;
  if (!editor.event) return;
  editor.event(subject, name, value);
  if (field.access !== 'initializeOnly') {
    walk.judge('an event', second, { ...once, may: AFRESH });
    return;
  }
  walk.judge('an event', second, NOTHING);
  walk.told('an event', ['bad-access']);
}

/** Outputs are nobody's to set. */
function walkOutput(type: string, name: string, editor: Editor): string[] {
  const subject = SUBJECTS[type]!;
  const walk = new Walk(editor, subject);
  const before = walk.look();
  editor.set(subject, name, nodeTypes[type]!.fields[name]!.default);
  walk.judge('a value', before, NOTHING);
  walk.told('a value', ['bad-access']);
  editor.unset(subject, name);
  walk.judge('the default', before, NOTHING);
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
export const ALL_FIELDS: readonly [type: string, field: string][] = Object.values(
  nodeTypes,
).flatMap(({ name, fields }) =>
  Object.keys(fields).map((field) => [name, field] as [string, string]),
);
