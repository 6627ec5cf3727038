import { describe } from 'node:test';
import { below, fact } from '../../../../core/helpers.js';
import { holds, LINK, net } from '../../../../core/effects/joints/nets.js';

describe('nets', () => {
  for (const [by, held] of Object.entries(holds))
    fact(`a net of 8 by 8, held ${by}, does not gape`, async () => {
      for (const accuracy of ['game', 'standard', 'fine'] as const) {
        const { w, widest } = await net(accuracy, 8, held(8));
        let gap = 0;
        for (let i = 0; i < 60; i++) {
          w.advance(1 / 60);
          gap = Math.max(gap, widest());
        }
        below(gap, LINK / 1000, `m at ${accuracy}`);
      }
    });
});

describe('large nets', () => {
  for (const by of ['by one side', 'taut, by its four corners'])
    fact(`a net of 20 by 20, held ${by}, does not gape`, async () => {
      const { w, widest } = await net('standard', 20, holds[by]!(20));
      let gap = 0;
      for (let i = 0; i < 60; i++) {
        w.advance(1 / 60);
        gap = Math.max(gap, widest());
      }
      below(gap, LINK / 1000, 'm');
    });
});
