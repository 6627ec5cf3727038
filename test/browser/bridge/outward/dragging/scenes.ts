import { draggable, listen, mouse, moveMouse, pixelOf } from './hand.js';
import { show } from '../../../scene.js';
import type { Thread } from '../../../threads.js';

export const CAMERA = '<viewpoint position="0 0 10" orientation="0 1 0 0"></viewpoint>';

export const box = (id: string) =>
  `<shape id="${id}"><appearance><material></material></appearance><box size="1 1 1"></box></shape>`;

export const collection = (attributes: string): string =>
  `<x3d-rigid-body-collection default ${attributes}></x3d-rigid-body-collection>`;

export const WEIGHTLESS = collection('gravity="0 0 0"');

/** One box at the origin, 1 m wide, before a camera 10 m away, and nothing that pulls it down. */
export const one = (attributes: string, thread: Thread = 'main'): string =>
  `${CAMERA}${collection(`gravity="0 0 0" thread="${thread}"`)}<transform>${box('s')}<x3d-rigid-body id="b" ${attributes}></x3d-rigid-body></transform>`;

export async function stage(content: string, name = 'b') {
  const { x3d, world } = await show(content, '#b, [def=b]');
  await draggable(x3d);
  await world.ask('stats');
  const body = world.node(name)!;
  const element = body.host as HTMLElement;
  return { x3d, world, body, element, events: listen(x3d) };
}

/** Where the front of the box at `from` is grabbed, and where that goes; pixels. */
export async function dragTo(x3d: Element, from: number[], to: number[]) {
  const start = pixelOf(x3d, from);
  const end = pixelOf(x3d, to);
  await mouse.move(start);
  await mouse.down();
  await moveMouse(start, end);
  return { start, end };
}
