import { createWorld } from '../../physics-core/inside.js';
import { BodyNode } from '../../physics-core/nodes/body/body.js';
import { stabilityCases } from './cases/index.js';

/**
 * Short cases, and the hash of all poses after so many steps at `standard`: the same bits in Node and in every browser. Where
 * the motion is changed on purpose, the test says what they are now.
 */
export const SMOKE: Record<string, string> = {
  S1: '6cd500a06e4b3117',
  S4: 'b90ae6dc1152c0b6',
  'S9 box': '66031e45cb47e0b5',
  S20: '0eba00b41f2e8ede',
  S21: 'b653eed682b2f18c',
};

const STEPS = 240;

/** FNV-1a over the bytes of all poses at `standard`: browsers hash by digest only on secure pages. */
export async function hashAfterSteps(id: string): Promise<string> {
  const { scene, world: fields } = stabilityCases.find((one) => one.id === id)!;
  const world = await createWorld({ rest: 'never', ...fields });
  scene(world);
  world.step(STEPS);
  const poses = [...world.nodes].flatMap((node) => {
    if (!(node instanceof BodyNode)) return [];
    const { p, q } = node.pose();
    return [...p, ...q];
  });
  world.destroy();
  let hash = 0xcbf29ce484222325n;
  for (const byte of new Uint8Array(new Float64Array(poses).buffer))
    hash = BigInt.asUintN(64, (hash ^ BigInt(byte)) * 0x100000001b3n);
  return hash.toString(16).padStart(16, '0');
}
