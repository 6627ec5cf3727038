import type { World } from '../../physics-core/inside.js';
import { pile, type Scene } from '../scenes.js';

const box = (...size: number[]) => ({ type: 'Box', size });

function floor(world: World): void {
  world.add('RigidBody', { fixed: true, position: [0, -0.5, 0], geometry: [box(100, 1, 100)] });
}

/** So many stacks of boxes of 1 m, so high. */
const stacks =
  (count: number, height: number) =>
  (world: World): void => {
    floor(world);
    for (let i = 0; i < count * height; i++)
      world.add('RigidBody', {
        position: [3 * Math.floor(i / height), (i % height) + 0.5, 0],
        geometry: [box(1, 1, 1)],
      });
  };

/** Side by side and one above the other, so far apart that none ever touches another. */
const falling =
  (count: number) =>
  (world: World): void => {
    for (let i = 0; i < count; i++)
      world.add('RigidBody', {
        position: [3 * (i % 10), 3 * (Math.floor(i / 10) % 10), 3 * Math.floor(i / 100)],
        geometry: [box(1, 1, 1)],
      });
  };

/** What the solve is paid for, and what it is not: all at `standard`, all awake. */
export const scenes: readonly Scene[] = [
  { name: '1000 boxes that fall and touch nothing', warmUp: 0.5, build: falling(1000) },
  { name: 'stack of 20 boxes', warmUp: 1, build: stacks(1, 20) },
  { name: '10 stacks of 10 boxes', warmUp: 1, build: stacks(10, 10) },
  { name: '200 boxes, heaped up, tumbling', warmUp: 0.5, build: pile(200) },
  { name: '200 boxes, heaped up, lying', warmUp: 8, build: pile(200) },
  { name: '1000 boxes, heaped up, tumbling', warmUp: 1, build: pile(1000) },
  { name: '1000 boxes, heaped up, after 6 s', warmUp: 6, build: pile(1000) },
];
