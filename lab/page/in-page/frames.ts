// Frames and the clock of a page, before any other script asks for them.

/** What a frame cost, milliseconds of script. */
export interface FrameCost {
  script: number;
  physics: number;
  /** X3DOM's own frame. */
  tick: number;
  /** From the last frame to this one. */
  gap: number;
}

/** Milliseconds that a frame stands for where they follow each other as fast as they can. */
const STEADY = 1000 / 60;

const realNow = performance.now.bind(performance);
const realDate = Date.now.bind(Date);
const realRequest = requestAnimationFrame.bind(globalThis);
const origin = realDate() - realNow();

let due = new Map<number, FrameRequestCallback>();
let next = 1;
/** The clock of the page where this frame began, and the true one. Within a frame both go alike. */
let [base, begun] = [0, 0];
let steady = false;
let before = 0;
const watched = { physics: 0, tick: 0 };
/** Since the last frame: what workers answered. */
let between = 0;

const clock = (): number => base + realNow() - begun;

/** Calls back whoever waits for a frame; what that takes is its script, and what was done since the last one. */
function run(now: number): FrameCost {
  const callbacks = due;
  due = new Map();
  Object.assign(watched, { physics: 0, tick: 0 });
  const start = realNow();
  [base, begun] = [now, start];
  for (const callback of callbacks.values()) callback(now);
  const script = realNow() - start + between;
  const cost = { ...watched, script, gap: now - before };
  before = now;
  between = 0;
  return cost;
}

/** Hears of each frame of the browser. */
let listener: ((cost: FrameCost) => void) | undefined;

function pump(now: number): void {
  if (steady) return;
  realRequest(pump);
  const cost = run(now);
  listener?.(cost);
}

export function install(): void {
  performance.now = clock;
  Date.now = () => origin + clock();
  window.requestAnimationFrame = (callback) => {
    due.set(next, callback);
    return next++;
  };
  window.cancelAnimationFrame = (id) => void due.delete(id);
  timeAnswers();
  realRequest(pump);
}

/** What workers answer is script of this page. */
function timeAnswers(): void {
  const onmessage = Object.getOwnPropertyDescriptor(Worker.prototype, 'onmessage')!;
  Object.defineProperty(Worker.prototype, 'onmessage', {
    ...onmessage,
    set(this: Worker, hear: (event: MessageEvent) => void) {
      onmessage.set!.call(this, (event: MessageEvent) => {
        const start = realNow();
        hear.call(this, event);
        between += realNow() - start;
      });
    },
  });
}

/** From now on frames come when they are asked for, each a sixtieth of a second after the last one. */
export function hold(): void {
  steady = true;
}

/** Frames are the browser's again. */
export function release(): void {
  steady = false;
  realRequest(pump);
}

export const steadyFrame = (): FrameCost => run(base + STEADY);

export const listen = (hear: typeof listener): void => {
  listener = hear;
};

/** What this method takes in a frame is physics, or X3DOM's frame. */
export function watchMethod(
  owner: Record<string, any>,
  name: string,
  part: keyof typeof watched = 'physics',
): void {
  const method = owner[name] as (...values: unknown[]) => unknown;
  owner[name] = function (...values: unknown[]) {
    const start = realNow();
    try {
      return method.apply(this, values);
    } finally {
      watched[part] += realNow() - start;
    }
  };
}

export { realNow };
