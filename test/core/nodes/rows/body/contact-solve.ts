import { addBody, addFloor, above, below, box, close, position, world } from '../../../helpers.js';
import type { Row } from '../row.js';

export const contactSolveRows: Row[] = [
  {
    effect: 'contact solve',
    fact: 'five boxes bear a hundred times their weight',
    run: async () => {
      const w = await world();
      addFloor(w);
      const pile = Array.from({ length: 6 }, (_, i) =>
        addBody(w, { mass: i < 5 ? 1 : 100, position: [0, 0.5 + i, 0], geometry: [box(1)] }),
      );
      w.advance(2);
      pile.forEach((body, i) => close(position(body), [0, 0.5 + i, 0], 1e-3, `m, box ${i}`));
    },
  },
  {
    effect: 'contact solve',
    fact: 'what touches causes it, and what comes apart ends it',
    run: async () => {
      const w = await world();
      addFloor(w);
      const isOn = () => w.effects.some(({ name, active }) => name === 'contact solve' && active);
      const body = addBody(w, { position: [0, 0.5, 0], geometry: [box(1)] });
      w.step(3);
      above(+isOn(), 0, 'on while they touch');
      body.event('position', [0, 9, 0]);
      w.step(3);
      below(+isOn(), 1, 'on while nothing touches');
    },
  },
];
