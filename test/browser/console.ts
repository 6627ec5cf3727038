/**
 * What the page writes to the console is part of what an author sees: each test names every message that comes in it,
 * as often as it comes, and a message too many or too few fails that test. Import this once per test file;
 * `test/browser/bridge/scene.ts` does.
 */
const said: string[] = [];
const claimed: string[] = [];

/** The test that runs expects one message for each of these: the code of a problem, or words of the message. */
export function claim(...words: string[]): void {
  claimed.push(...words);
}

/** Comes and goes with the load of the machine. */
const ANY_TIME = '[lag]';

/** An element behind a message is one to click. */
function inWords(part: unknown): string {
  return part instanceof Element ? `<${part.localName}>` : String(part);
}

for (const level of ['info', 'warn', 'error'] as const) {
  console[level] = (...parts: unknown[]): void => void said.push(parts.map(inWords).join(' '));
}

const list = (messages: string[]): string => [...new Set(messages)].join(' | ');

function compare(messages: string[], expected: string[]): void {
  const left = messages.filter((message) => !message.includes(ANY_TIME));
  const unheard = expected.filter((words) => {
    const at = left.findIndex((message) => message.includes(words));
    if (at >= 0) left.splice(at, 1);
    return at < 0;
  });
  if (left.length > 0) throw new Error(`unclaimed console message: ${list(left)}`);
  if (unheard.length > 0) throw new Error(`claimed but never said: ${unheard.join(', ')}`);
}

// Compared at the end of the test itself: a hook that throws would end its whole suite.
const register = globalThis.it;
const checked = (title: string, test: Mocha.AsyncFunc): Mocha.Test =>
  register(title, async function () {
    let messages: string[] = [];
    let expected: string[] = [];
    try {
      await test.call(this);
    } finally {
      messages = said.splice(0);
      expected = claimed.splice(0);
    }
    compare(messages, expected);
  });
globalThis.it = Object.assign(checked, register) as Mocha.TestFunction;
