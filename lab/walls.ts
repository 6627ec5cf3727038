import type { World } from '../physics-core/inside.js';
import type { CaseBody } from './case.js';

/** Four walls, a metre thick and so many high, about a square that reaches `half` metres to each side. */
export function wallsOf(half: number, height: number): CaseBody[] {
  const [out, long] = [half + 0.5, 2 * (half + 1)];
  return [
    [out, 0],
    [-out, 0],
    [0, out],
    [0, -out],
  ].map(([x, z], i) => ({
    name: `wall ${i + 1}`,
    fixed: true,
    position: [x!, height / 2, z!],
    shape: { type: 'Box', size: [x ? 1 : long, height, z ? 1 : long] },
  }));
}

export function addBodies(world: World, bodies: readonly CaseBody[]): void {
  for (const { name: _, shape, ...fields } of bodies)
    world.add('RigidBody', { ...fields, geometry: [shape] });
}

export const addWalls = (world: World, half: number, height: number): void =>
  addBodies(world, wallsOf(half, height));
