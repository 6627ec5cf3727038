// The scene of the page that is measured.

interface Canvas {
  tick(...args: unknown[]): unknown;
  doc: {
    _viewarea: unknown;
    ctx: {
      ctx3d: WebGL2RenderingContext;
      numDrawCalls: number;
      renderScene(area: unknown): void;
    };
  };
}

export type Collection = Element & {
  world: { stats: { ms: { step: number; write: number } }; paused: boolean };
};

type Shown = Element & { runtime: { canvas: Canvas } };

export const x3d = (): Shown => document.querySelector<Shown>('x3d')!;

export const collection = (): Collection =>
  document.querySelector<Collection>('x3d-rigid-body-collection')!;

export const drawPlainly = (plainly: boolean): void =>
  plainly ? collection().setAttribute('batch', 'false') : collection().removeAttribute('batch');

export const nextFrame = (): Promise<number> =>
  new Promise((resolve) => requestAnimationFrame(resolve));

export const middle = (list: number[]): number => list.toSorted((a, b) => a - b)[list.length >> 1]!;

/** Milliseconds of each of x3dom's frames from now on. */
export function hearTicks(): number[] {
  const { canvas } = x3d().runtime;
  const ticks: number[] = [];
  const { tick } = canvas;
  canvas.tick = function (...args) {
    const start = performance.now();
    const result = tick.apply(this, args);
    ticks.push(performance.now() - start);
    return result;
  };
  return ticks;
}
