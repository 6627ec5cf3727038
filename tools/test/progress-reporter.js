// Reporter of Node's test runner: a line every few seconds, of how many of the facts that are known so far are done.

/** Milliseconds between two lines. */
const APART = 10_000;

export default async function* progress(events) {
  const start = Date.now();
  let last = start;
  let [known, done] = [0, 0];
  for await (const { type, data } of events) {
    if (data.nesting > 0) continue;
    if (type === 'test:enqueue') known++;
    if (type === 'test:pass' || type === 'test:fail') done++;
    const now = Date.now();
    if (now - last < APART) continue;
    last = now;
    const share = Math.round((100 * done) / Math.max(known, done, 1));
    yield `… in Node: ${share} % of ${known} facts, ${Math.round((now - start) / 1000)} s\n`;
  }
}
