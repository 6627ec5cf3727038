import './console.js';
import { faults } from '../../elements/bridge/words/faults.js';
import '../../elements/index.js';
import { worldOf, type World } from './inside.js';
import { advice, chunks } from '../../physics-core/inside.js';

// What comes late would have worlds wait for it: chunks.long.test.ts has that.
await Promise.all([advice, faults, ...chunks].map((chunk) => chunk.load()));

/** Puts an `<x3d>` with this content into the page and waits until its world has started. */
export async function show(
  content: string,
  selector = 'x3d-rigid-body-collection, rigidbodycollection',
) {
  const x3d = place(content);
  const element = x3d.querySelector(selector) ?? x3d;
  const world = worldOf(element)!;
  await world.ready;
  return { x3d, world };
}

/** The same, without waiting. */
export function place(content: string): HTMLElement {
  document.body.innerHTML = `<x3d width="300px" height="200px"><scene>${content}</scene></x3d>`;
  return document.body.firstElementChild as HTMLElement;
}

export const nextFrame = (): Promise<unknown> =>
  new Promise((resolve) => requestAnimationFrame(resolve));

export const wait = (milliseconds: number): Promise<unknown> =>
  new Promise((resolve) => setTimeout(resolve, milliseconds));

/** Of a body in the world, by its DEF or id: where it is, whatever is drawn. */
export const position = (world: World, name: string): number[] =>
  world.node(name)!.get('position') as number[];

/** Of the problems that a world has told of. */
export const codes = (world: { problems: readonly { code: string }[] }): string[] =>
  world.problems.map(({ code }) => code);

/** What x3dom draws a Transform or collidable with: the translation of its world matrix. */
export function drawnAt(element: Element): number[] {
  const node = (
    element as unknown as { _x3domNode: { getCurrentTransform(): Record<string, number> } }
  )._x3domNode;
  const m = node.getCurrentTransform();
  return [m._03, m._13, m._23];
}

/** Long enough for what moved to be drawn. */
export async function drawn(): Promise<void> {
  for (let i = 0; i < 3; i++) await nextFrame();
}

/** Milliseconds after which what is waited for won't come: a page that is slow to draw, on a busy machine, takes seconds. */
export const PATIENCE = 40_000;

/** Waits for a state. */
export async function until(holds: () => boolean, milliseconds = PATIENCE): Promise<void> {
  const end = performance.now() + milliseconds;
  while (!holds()) {
    if (performance.now() > end) throw new Error(`not within ${milliseconds} ms: ${holds}`);
    await nextFrame();
  }
}
