import { expect } from 'chai';
import { claim } from './console.js';
import { factsOf } from '../conformance/all.js';
import { judge, objections } from '../conformance/judge.js';
import { openInPage, tags } from '../conformance/page-driver.js';

const spellings = Object.entries(tags);
let shown = 0;

for (const [type, facts] of Object.entries(factsOf)) {
  describe(`conformance of ${type}`, () => {
    for (const fact of facts) {
      // By turns: the same facts in both spellings would take twice the time and find nothing more.
      const [spelling, tag] = spellings[shown++ % spellings.length]!;
      it(`${fact.field}: ${fact.says} (${spelling} tags)`, async () => {
        claim(...(fact.tells ?? []).map((code) => `[${code}]`));
        const stage = await openInPage(fact, tag);
        expect(objections(await judge(fact, stage))).to.eql([]);
        await stage.close();
      });
    }
  });
}
