import { PATIENCE, wait } from '../../scene.js';
import { worldOf } from '../../inside.js';

export type PageWorld = NonNullable<ReturnType<typeof worldOf>>;

export const append = (x3d: Element, markup: string): Element => {
  const scene = x3d.querySelector('scene')!;
  scene.insertAdjacentHTML('beforeend', markup);
  return scene.lastElementChild!;
};

export const ball = (attributes = ''): string =>
  `<x3d-rigid-body ${attributes}><x3d-collidable-shape><shape><sphere></sphere></shape></x3d-collidable-shape></x3d-rigid-body>`;

export const collection = (attributes = '', inner = ball()): string =>
  `<x3d-rigid-body-collection ${attributes}>${inner}</x3d-rigid-body-collection>`;

/** How its promise settles, as far as it has. */
export async function outcome(world: PageWorld): Promise<unknown> {
  const late = wait(PATIENCE).then(() => 'neither');
  return Promise.race([world.ready, late]).then(
    (value) => (value === world ? 'ready' : value),
    (reason: { code: string }) => reason.code,
  );
}
