/**
 * What the page writes to the console is part of what an author sees: a message that no test claims fails the test
 * in which it comes. Import this once per test file; `test/browser/bridge/scene.ts` does.
 */
const said: string[] = [];
const claimed = new Set<string>();

/** The test that runs expects problems with these codes, or other console messages that contain these words. */
export function claim(...words: string[]): void {
  for (const word of words) claimed.add(word);
}

for (const level of ['info', 'warn', 'error'] as const) {
  console[level] = (...parts: unknown[]): void => void said.push(parts.map(String).join(' '));
}

afterEach(function () {
  const unclaimed = said.filter((message) => ![...claimed].some((word) => message.includes(word)));
  const unheard = [...claimed].filter((word) => !said.some((message) => message.includes(word)));
  said.length = 0;
  claimed.clear();
  if (this.currentTest?.isFailed()) return;
  if (unclaimed.length > 0) throw new Error(`unclaimed console message: ${unclaimed.join(' | ')}`);
  if (unheard.length > 0) throw new Error(`claimed but never said: ${unheard.join(', ')}`);
});
