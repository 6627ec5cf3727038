import { bodies, colored, showBatched } from './pictures.js';

export const COUNT = 12;

export const boxes = bodies(COUNT, (i) => `${colored(i)}<box size="1 1 1"></box>`);

export type Shown = Awaited<ReturnType<typeof showBatched>>;

export const find = ({ x3d }: Shown, name: string): Element => x3d.querySelector(name)!;
