import { executeServerCommand, sendMouse } from '@web/test-runner-commands';
import { nextFrame, until } from '../../../scene.js';
import type { PhysicsNode, World } from '../../../inside.js';

// A person before the screen: real input of the browser, and where things are in its window.

type Vec3 = number[];

interface Projection {
  multFullMatrixPnt(point: unknown): { x: number; y: number; z: number };
}

interface Area {
  getWCtoCCMatrix(): Projection;
  getCCtoWCMatrix(): Projection;
  getViewMatrix(): { toString(): string };
}

const areaOf = (x3d: Element): Area => (x3d as any).runtime.canvas.doc._viewarea;

const vector = ([x, y, z]: Vec3): unknown => new (globalThis as any).x3dom.fields.SFVec3f(x, y, z);

/** The whole pixel of the window nearest to where a point of the scene shows. */
export function pixelOf(x3d: Element, point: Vec3): [number, number] {
  const { x, y } = areaOf(x3d).getWCtoCCMatrix().multFullMatrixPnt(vector(point));
  const { left, top, width, height } = x3d.querySelector('canvas')!.getBoundingClientRect();
  return [Math.round(left + ((x + 1) / 2) * width), Math.round(top + ((1 - y) / 2) * height)];
}

/** Where the line of sight through a pixel meets the plane z of a camera that looks along it. */
export function pointUnder(x3d: Element, [px, py]: [number, number], z: number): Vec3 {
  const { left, top, width, height } = x3d.querySelector('canvas')!.getBoundingClientRect();
  const at = (depth: number): Vec3 => {
    const ndc = [(2 * (px - left)) / width - 1, 1 - (2 * (py - top)) / height, depth];
    const { x, y, z } = areaOf(x3d).getCCtoWCMatrix().multFullMatrixPnt(vector(ndc));
    return [x, y, z];
  };
  const [a, b] = [at(-1), at(1)];
  const share = (z - a[2]!) / (b[2]! - a[2]!);
  return a.map((value, i) => value + (b[i]! - value) * share);
}

export const camera = (x3d: Element): string => areaOf(x3d).getViewMatrix().toString();

/** Long enough for the code of dragging to be loaded, and for x3dom to have drawn. */
export async function draggable(x3d: Element): Promise<void> {
  await until(() => x3d.querySelector('.x3d-physics-handles') !== null);
  for (let i = 0; i < 3; i++) await nextFrame();
}

export const mouse = {
  move: (position: [number, number]) => sendMouse({ type: 'move', position }),
  down: () => sendMouse({ type: 'down' }),
  up: () => sendMouse({ type: 'up' }),
};

/** In steps, as a hand moves. */
export async function moveMouse(from: number[], to: number[], steps = 8): Promise<void> {
  for (let i = 1; i <= steps; i++) {
    const at = from.map((value, n) => Math.round(value + ((to[n]! - value) * i) / steps));
    await mouse.move(at as [number, number]);
    await nextFrame();
  }
}

type Touch = 'start' | 'move' | 'end' | 'cancel';

export const touch = (type: Touch, ...points: [number, number][]): Promise<unknown> =>
  executeServerCommand('send-touch', { type, points: points.map(([x, y], id) => ({ x, y, id })) });

/** Drag events in the order in which they come at an element. */
export function listen(element: EventTarget): CustomEvent[] {
  const events: CustomEvent[] = [];
  for (const type of ['bodydragstart', 'bodydrag', 'bodydragend'])
    EventTarget.prototype.addEventListener.call(element, type, (event) =>
      events.push(event as CustomEvent),
    );
  return events;
}

/** Their names, each once in a row. */
export const names = (events: CustomEvent[]): string[] =>
  events.map(({ type }) => type).filter((type, i, all) => type !== all[i - 1]);

export const position = (node: PhysicsNode): Vec3 => node.get('position') as Vec3;

/** What a drag may not change. */
export function objects(world: World) {
  const { created, destroyed, bodies, joints, heapBytes } = world.stats;
  return { created, destroyed, bodies, joints, heapBytes };
}

export const far = (a: Vec3, b: Vec3): number => Math.hypot(...a.map((value, i) => value - b[i]!));
