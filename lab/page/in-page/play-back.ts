import { ourWorld } from './adapters.js';
import { hold, release, steadyFrame } from './frames.js';

/** Drawing alone: so many seconds of the scene are recorded, and shown again from now on; nothing is simulated. */
export async function playBack(seconds: number): Promise<void> {
  const world = ourWorld();
  const timeline = await world.record({ seconds: 2 * seconds });
  hold();
  // A frame whose steps take too long stands for less than its time.
  while (timeline.to - timeline.from < seconds) steadyFrame();
  release();
  timeline.seek(timeline.from);
  timeline.play();
}
