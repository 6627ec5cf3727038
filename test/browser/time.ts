import { nextFrame } from './scene.js';
import type { World } from './inside.js';

/**
 * What may be said of time on a machine that is as busy as it likes: worlds live by the moments that the browser gives its
 * frames. Such a moment may lie well before its frame is drawn, and before an act that the frame is the first to show.
 */

/** Longest stretch that a page takes for one slow frame, seconds: see elements/bridge/drawing/loop.ts. */
const LONGEST = 1;

/** Seconds of frames from the next one on. */
export class FrameTime {
  passed = 0;
  #last: number | undefined;
  #request = 0;

  constructor() {
    this.#look();
  }

  #look(): void {
    this.#request = requestAnimationFrame((now) => {
      this.passed += Math.min(LONGEST, (now - (this.#last ?? now)) / 1000);
      this.#last = now;
      this.#look();
    });
  }

  /** Answers the seconds that passed. */
  stop(): number {
    cancelAnimationFrame(this.#request);
    return this.passed;
  }
}

/** Seconds that a world took for its own: simulated, or dropped where the machine could not keep up. */
export const taken = ({ time, stepping }: World): number => time + stepping.dropped;

/** A step, which may be due already or not yet. */
export const step = ({ timeStep }: World): number => timeStep + 1e-6;

/** Until an element has come into view or gone out of it, and all that look at it have been told. */
export async function inView(element: Element, isIt: boolean): Promise<void> {
  await new Promise<void>((resolve) => {
    const observer = new IntersectionObserver((entries) => {
      if (entries.at(-1)!.isIntersecting !== isIt) return;
      observer.disconnect();
      resolve();
    });
    observer.observe(element);
  });
  await nextFrame();
}
