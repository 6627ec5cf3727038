import { collection, middle, x3d } from './shown.js';

const settle = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

/** Milliseconds that a change of one body costs beyond a frame without one: the change, what follows, and the frame. */
export async function changes(times: number): Promise<Record<string, number>> {
  const scene = x3d().querySelector('scene')!;
  const { doc } = x3d().runtime.canvas;
  collection().world.paused = true;
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
