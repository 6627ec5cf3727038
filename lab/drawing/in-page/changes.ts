// What is measured of a page, in the page. Each function is sent there as text, so that it may use nothing around it.

/** Milliseconds of script per frame, and what a frame asks of WebGL. */
export interface Frames {
  /** Poses into x3dom. */
  write: number;
  /** x3dom's own frame. */
  tick: number;
  calls: number;
  draws: number;
}

/** Both ways of one page, in turn. */
export interface Ways {
  plain: Frames[];
  batched: Frames[];
}

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
interface Shown extends Element {
  runtime: { canvas: Canvas };
  world: { stats: { ms: { write: number } }; paused: boolean };
}

/** `stub`: WebGL does nothing, so that script alone is measured. */
export async function frames({ stub, rounds }: { stub: boolean; rounds: number }): Promise<Ways> {
  const { canvas } = document.querySelector<Shown>('x3d')!.runtime;
  const collection = document.querySelector<Shown>('#c')!;
  const gl = canvas.doc.ctx.ctx3d as unknown as Record<string, unknown>;
  let calls = 0;
  const keeps = /^(get|create|is|compile|link|attach|shaderSource|bindAttrib|read)/;
  for (const name in gl) {
    const method = gl[name];
    if (typeof method !== 'function') continue;
    gl[name] = (...args: unknown[]): unknown => {
      calls++;
      return stub && !keeps.test(name) ? undefined : (method.apply(gl, args) as unknown);
    };
  }
  const ticks: number[] = [];
  const { tick } = canvas;
  canvas.tick = function (...args) {
    const start = performance.now();
    const result = tick.apply(this, args);
    ticks.push(performance.now() - start);
    return result;
  };
  const nextFrame = (): Promise<number> => new Promise((resolve) => requestAnimationFrame(resolve));
  const middle = (list: number[]): number => list.sort((a, b) => a - b)[list.length >> 1]!;
  const measure = async (): Promise<Frames> => {
    for (let i = 0; i < 6; i++) await nextFrame();
    ticks.length = 0;
    const writes: number[] = [];
    calls = 0;
    for (let i = 0; i < 24; i++) {
      await nextFrame();
      writes.push(collection.world.stats.ms.write);
    }
    return {
      write: middle(writes),
      calls: Math.round(calls / ticks.length),
      tick: middle(ticks),
      draws: canvas.doc.ctx.numDrawCalls,
    };
  };
  const ways: Ways = { plain: [], batched: [] };
  for (let i = 0; i < rounds; i++) {
    collection.setAttribute('batch', 'false');
    ways.plain.push(await measure());
    collection.removeAttribute('batch');
    ways.batched.push(await measure());
  }
  return ways;
}

/** Milliseconds that a change of one body costs beyond a frame without one: the change, what follows, and the frame. */
export async function changes(times: number): Promise<Record<string, number>> {
  const x3d = document.querySelector<Shown>('x3d')!;
  const scene = x3d.querySelector('scene')!;
  const { doc } = x3d.runtime.canvas;
  document.querySelector<Shown>('#c')!.world.paused = true;
  const settle = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));
  const middle = (list: number[]): number => list.sort((a, b) => a - b)[list.length >> 1]!;
  const frame = (): number => {
    const start = performance.now();
    doc.ctx.renderScene(doc._viewarea);
    return performance.now() - start;
  };
  const all = scene.querySelectorAll('transform');
  const copy = all[all.length - 1]!.outerHTML.replace(
    /translation="[^"]*"/,
    'translation="0 99 0"',
  );
  const kinds: Record<string, (i: number) => void> = {
    add: () => scene.insertAdjacentHTML('beforeend', copy),
    remove: () => scene.lastElementChild!.remove(),
    recolour: (i) =>
      scene.querySelector('material')!.setAttribute('diffuseColor', `${i % 2} 0.5 ${i % 3}`),
  };
  const found: Record<string, number[]> = { add: [], remove: [], recolour: [] };
  for (let i = 0; i < times; i++)
    for (const [kind, change] of Object.entries(kinds)) {
      await settle();
      frame();
      const idle = Math.min(frame(), frame());
      const start = performance.now();
      change(i);
      // What the change has follow runs before this.
      await Promise.resolve();
      await Promise.resolve();
      await Promise.resolve();
      const followed = performance.now() - start;
      found[kind]!.push(followed + frame() - idle);
    }
  return Object.fromEntries(Object.entries(found).map(([kind, list]) => [kind, middle(list)]));
}
