import { createWorld } from '../../physics-core/create.js';
import { bitsOf } from './bits.js';
import { stabilityCases } from './cases/index.js';

/**
 * Short cases, and the hash of all poses after so many steps at `standard`: the same bits in Node and in every browser. Where
 * the motion is changed on purpose, the test says what they are now.
 */
export const SMOKE: Record<string, string> = {
  S1: '6cd500a06e4b3117',
  S4: '7045ab299b964342',
  'S9 box': '66031e45cb47e0b5',
  S20: '0eba00b41f2e8ede',
  S21: '3d5aab959c4b5214',
};

const STEPS = 240;

export async function hashAfterSteps(id: string): Promise<string> {
  const { scene, world: fields } = stabilityCases.find((one) => one.id === id)!;
  const world = await createWorld({ rest: 'never', ...fields });
  scene(world);
  world.step(STEPS);
  const bits = bitsOf(world);
  world.destroy();
  return bits;
}
