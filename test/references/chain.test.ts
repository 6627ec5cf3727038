import { chainEnd } from '../../references/chain.js';
import { below, distance, fact } from '../core/helpers.js';

fact('the reference of one link is a pendulum: at the bottom after K(½) √(l / g)', () => {
  const link = { link: 1, centre: 1, masses: [1], moments: [0], gravity: 9.81 };
  const quarter = 1.854074677301372 / Math.sqrt(9.81);
  // A time scale that puts the bottom on a frame.
  const stretched = { ...link, gravity: 9.81 * (quarter * 2) ** 2 };
  below(distance(chainEnd(stretched, 0.5, 64).at(-1)!, [0, -1, 0]), 1e-9, 'm');
});
