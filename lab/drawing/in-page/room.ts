import { collection, drawPlainly, hearTicks, middle, nextFrame } from './shown.js';

/** Milliseconds of a frame: of the physics, of drawing, and until the next one. */
export interface RoomFrames {
  physics: number;
  drawing: number;
  frame: number;
}

/** Frames before a turn is measured, and milliseconds that one takes at least. */
const [BEFORE, LEAST] = [4, 1500];

/** Frames as the browser gives them while the boxes fall and are stirred: one by one and in few calls, in turns. */
export async function room(rounds: number): Promise<Record<'plain' | 'batched', RoomFrames[]>> {
  const { world } = collection();
  const ticks = hearTicks();

  async function turn(plainly: boolean): Promise<RoomFrames> {
    drawPlainly(plainly);
    for (let i = 0; i < BEFORE; i++) await nextFrame();
    ticks.length = 0;
    const [steps, writes, frames]: number[][] = [[], [], []];
    const start = await nextFrame();
    for (let last = start; last - start < LEAST || frames!.length < 10;) {
      const now = await nextFrame();
      frames!.push(now - last);
      last = now;
      steps!.push(world.stats.ms.step);
      writes!.push(world.stats.ms.write);
    }
    const drawing = middle(writes!) + middle(ticks);
    return { physics: middle(steps!), drawing, frame: middle(frames!) };
  }

  const found: Record<'plain' | 'batched', RoomFrames[]> = { plain: [], batched: [] };
  for (let i = 0; i < rounds; i++) {
    found.plain.push(await turn(true));
    found.batched.push(await turn(false));
  }
  return found;
}
