import { type World } from '../../../../../physics-core/inside.js';
import { boxChain } from '../../../../../references/chains.js';
import { addBoxChain, type Jointed } from '../../../../core/effects/joints/scenes.js';
import { below, fact, world } from '../../../../core/helpers.js';

const EARTH = [0, -9.81, 0];

/** Sum of all gaps over the length, the most there is at the end of a frame. */
function worstSum(w: World, joints: Jointed['joints'], length: number, seconds: number): number {
  let worst = 0;
  for (let frame = 0; frame < 60 * seconds; frame++) {
    w.advance(1 / 60);
    worst = Math.max(worst, joints.reduce((sum, joint) => sum + joint.gap, 0) / length);
  }
  return worst;
}

fact(
  'a hundred hinged links crack like a whip, and their gaps sum up to less than 1 %',
  async () => {
    const w = await world({ accuracy: 'standard', gravity: EARTH });
    const { joints } = addBoxChain(w, boxChain(100));
    below(worstSum(w, joints, 10, 5), 0.01, 'of the length');
  },
);
