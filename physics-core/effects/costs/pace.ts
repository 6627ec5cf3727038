/** Frames that are looked back on, seconds: long enough to be even, short enough to follow. */
const LOOK_BACK = 2;
/** That many frames of the fastest screens. */
const MOST = LOOK_BACK * 240;

/** Of one frame: seconds since the one before, steps that were taken, and milliseconds of the main thread. */
const COLUMNS = ['seconds', 'steps', 'physics', 'listeners', 'drawing'] as const;

/** How frames follow each other, and what fills them. */
export interface FramePace {
  framesPerSecond: number;
  stepsPerFrame: number;
  /** Milliseconds from one frame to the next. */
  ms: number;
  /** Shares of that, 0 to 1: Bullet and effects, listeners of steps, and bringing poses to the picture and drawing it. */
  physics: number;
  listeners: number;
  drawing: number;
}

/** Frames of late while time passes, with or without a step. */
export class Pace {
  /** Per frame its columns; the oldest is overwritten. */
  readonly #ring = new Float64Array(MOST * COLUMNS.length);
  #frames = 0;

  add(seconds: number, steps: number, physics: number, listeners: number, drawing: number): void {
    const at = (this.#frames++ % MOST) * COLUMNS.length;
    this.#ring[at] = seconds;
    this.#ring[at + 1] = steps;
    this.#ring[at + 2] = physics;
    this.#ring[at + 3] = listeners;
    this.#ring[at + 4] = drawing;
  }

  /** Undefined before the first frame. */
  get report(): FramePace | undefined {
    const [frames, [seconds, steps, physics, listeners, drawing]] = this.#sums();
    if (frames === 0) return undefined;
    const share = (ms: number): number => Math.min(1, ms / 1000 / seconds);
    return {
      framesPerSecond: frames / seconds,
      stepsPerFrame: steps / frames,
      ms: (1000 * seconds) / frames,
      physics: share(physics),
      listeners: share(listeners),
      drawing: share(drawing),
    };
  }

  /** Of each column, over the newest frames that fill the time looked back on. */
  #sums(): [frames: number, sums: [number, number, number, number, number]] {
    const sums: [number, number, number, number, number] = [0, 0, 0, 0, 0];
    const kept = Math.min(this.#frames, MOST);
    let frames = 0;
    while (frames < kept && sums[0] < LOOK_BACK) {
      const at = ((this.#frames - ++frames) % MOST) * COLUMNS.length;
      for (let i = 0; i < sums.length; i++) sums[i]! += this.#ring[at + i]!;
    }
    return [frames, sums];
  }
}
