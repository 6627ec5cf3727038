// Markup in an address. `#example=…` names an example of the menu, and `#edits=…` what was changed of it, so that it stays
// short; `#shared=…` is a whole text compressed, `#markup=…` as it is; `&run=…` behind any of them is what was recorded of
// it. Nothing of it is sent to a server.
import { deflated, inflated, fromBase64, textOf, toBase64 } from './packed.js';
import { editsBetween, withEdits } from './text/edits.js';

/** What the menu opens, by its name in addresses. */
export interface Named {
  id: string;
  markup: string;
}

const UNREADABLE = 'The address holds no markup that can be read: it may have been cut short.';
const UNKNOWN = 'The address names an example that is not here any more.';
const CHANGED =
  'The example that this address starts from has changed since: the edits of the address no longer fit it.';

/** For links into the playground, made at once. `base` is where the site lies. */
export const playgroundAddress = (markup: string, base = '/'): string =>
  `${base}playground.html#markup=${toBase64(new TextEncoder().encode(markup))}`;

/** Of an example as it is. */
export const exampleHash = ({ id }: Named): string => `#example=${id}`;

/** For addresses that people send to each other: the shortest that holds the text. */
export async function sharedHash(markup: string, example?: Named): Promise<string> {
  if (markup === example?.markup) return exampleHash(example);
  const whole = `#shared=${await deflated(markup)}`;
  if (!example) return whole;
  const edits = [signOf(example.markup), ...editsBetween(example.markup, markup)];
  const edited = `#example=${example.id}&edits=${await deflated(JSON.stringify(edits))}`;
  return edited.length < whole.length ? edited : whole;
}

export interface Found {
  markup: string;
  /** The one it is of. */
  example?: Named;
  /** What was recorded, packed. */
  run?: string;
}

/** What an address has behind its #; undefined where that is no markup. */
export async function foundIn(
  hash: string,
  examples: readonly Named[] = [],
): Promise<Found | undefined> {
  const [text, run] = hash.split('&run=') as [string, string | undefined];
  const found = await markupIn(text, examples);
  return found && run !== undefined ? { ...found, run } : found;
}

/** The same, without what was recorded. */
export async function markupIn(
  hash: string,
  examples: readonly Named[] = [],
): Promise<Found | undefined> {
  const [, id, packed] = /^#example=([^&]*)(?:&edits=(.*))?$/s.exec(hash) ?? [];
  if (id !== undefined) return ofExample(id, packed, examples);
  const [, kind, value] = /^#(markup|shared)=(.*)$/s.exec(hash) ?? [];
  if (!kind) return undefined;
  const unpack = async () => (kind === 'shared' ? inflated(value!) : textOf(fromBase64(value!)));
  return { markup: await orUnreadable(unpack) };
}

async function ofExample(id: string, packed: string | undefined, examples: readonly Named[]) {
  const example = examples.find((each) => each.id === id);
  if (!example) throw new Error(UNKNOWN);
  if (packed === undefined) return { markup: example.markup, example };
  const read = async () => JSON.parse(await inflated(packed)) as [string, ...never[]];
  const [sign, ...edits] = await orUnreadable(read);
  if (sign !== signOf(example.markup)) throw new Error(CHANGED);
  return { markup: await orUnreadable(async () => withEdits(example.markup, edits)), example };
}

async function orUnreadable<T>(read: () => Promise<T>): Promise<T> {
  try {
    return await read();
  } catch {
    throw new Error(UNREADABLE);
  }
}

/** Tells another text of the same name: 32 bits by FNV-1a, in letters. */
function signOf(text: string): string {
  let hash = 0x811c9dc5;
  for (let i = 0; i < text.length; i++) hash = Math.imul(hash ^ text.charCodeAt(i), 0x01000193);
  return (hash >>> 0).toString(36);
}
