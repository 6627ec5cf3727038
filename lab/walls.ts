import type { World } from '../physics-core/inside.js';

/** Four walls, a metre thick and so many high, about a square that reaches `half` metres to each side. */
export function addWalls(world: World, half: number, height: number): void {
  const [out, long] = [half + 0.5, 2 * (half + 1)];
  for (const [x, z] of [
    [out, 0],
    [-out, 0],
    [0, out],
    [0, -out],
  ])
    world.add('RigidBody', {
      fixed: true,
      position: [x, height / 2, z],
      geometry: [{ type: 'Box', size: [x ? 1 : long, height, z ? 1 : long] }],
    });
}
