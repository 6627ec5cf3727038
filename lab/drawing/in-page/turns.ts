import { collection, drawPlainly, hearTicks, middle, nextFrame, x3d } from './shown.js';
import { ThreeBoxes } from './three-boxes.js';
import { countCalls } from './webgl.js';

/** Milliseconds of script per frame, and what a frame asks of WebGL. */
export interface Frames {
  /** Poses into what is drawn. */
  write: number;
  /** The frame itself. */
  tick: number;
  calls: number;
}

export type Way = 'plain' | 'batched' | 'three';

/** Frames before a turn is measured, and those that are. */
const [BEFORE, MEASURED] = [6, 24];

const medianOf = (writes: number[], ticks: number[], calls: number): Frames => ({
  write: middle(writes),
  tick: middle(ticks),
  calls: Math.round(calls / ticks.length),
});

/** Script per frame in turns: x3dom one by one, in one call, and three.js. */
export async function turns(stub: boolean, rounds: number): Promise<Record<Way, Frames[]>> {
  const { canvas } = x3d().runtime;
  const { world } = collection();
  const ours = countCalls(canvas.doc.ctx.ctx3d, stub);
  const ticks = hearTicks();
  const boxes = new ThreeBoxes(document.querySelector('canvas')!);
  const theirs = countCalls(boxes.gl, stub);

  async function byX3dom(plainly: boolean): Promise<Frames> {
    drawPlainly(plainly);
    for (let i = 0; i < BEFORE; i++) await nextFrame();
    ticks.length = ours.calls = 0;
    const writes: number[] = [];
    for (let i = 0; i < MEASURED; i++) {
      await nextFrame();
      writes.push(world.stats.ms.write);
    }
    return medianOf(writes, ticks, ours.calls);
  }

  /** Meanwhile nothing else on the page moves. */
  async function byThree(): Promise<Frames> {
    world.paused = true;
    const all: { write: number; tick: number }[] = [];
    for (let i = 0; i < BEFORE + MEASURED; i++) {
      await nextFrame();
      if (i === BEFORE) theirs.calls = 0;
      all.push(boxes.frame());
    }
    world.paused = false;
    const measured = all.slice(BEFORE);
    return medianOf(
      measured.map(({ write }) => write),
      measured.map(({ tick }) => tick),
      theirs.calls,
    );
  }

  const found: Record<Way, Frames[]> = { plain: [], batched: [], three: [] };
  for (let i = 0; i < rounds; i++) {
    found.plain.push(await byX3dom(true));
    found.batched.push(await byX3dom(false));
    found.three.push(await byThree());
  }
  return found;
}
