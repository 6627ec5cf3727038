import { expect } from 'chai';
import { claim } from './console.js';
import { factsOf } from '../conformance/all.js';
import type { Fact } from '../conformance/fact.js';
import { judge, objections } from '../conformance/judge.js';
import { openInPage, tags } from '../conformance/page-driver.js';
import type { Thread } from './threads.js';

const spellings = Object.entries(tags);

/** The facts of each node in this page, with the steps of their worlds taken on that thread; `without` those. */
export function prove(
  thread: Thread,
  without: (type: string, fact: Fact) => boolean = () => false,
): void {
  let shown = 0;
  for (const [type, all] of Object.entries(factsOf)) {
    const facts = all.filter((fact) => !without(type, fact));
    if (facts.length === 0) continue;
    describe(`conformance of ${type}`, () => {
      for (const fact of facts) {
        // By turns: the same facts in both spellings would take twice the time and find nothing more.
        const [spelling, tag] = spellings[shown++ % spellings.length]!;
        it(`${fact.field}: ${fact.says} (${spelling} tags)`, async () => {
          claim(...(fact.tells ?? []).map((code) => `[${code}]`));
          const stage = await openInPage(fact, tag, thread);
          expect(objections(await judge(fact, stage))).to.eql([]);
          await stage.close();
        });
      }
    });
  }
}
