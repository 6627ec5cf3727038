import type { World } from '../../physics-core/inside.js';
import { BodyNode } from '../../physics-core/nodes/body/body.js';

/** FNV-1a over the bytes of all poses, as they are now: browsers hash by digest only on secure pages. */
export function bitsOf(world: World): string {
  const poses = [...world.nodes].flatMap((node) => {
    if (!(node instanceof BodyNode)) return [];
    const { p, q } = node.pose();
    return [...p, ...q];
  });
  let hash = 0xcbf29ce484222325n;
  for (const byte of new Uint8Array(new Float64Array(poses).buffer))
    hash = BigInt.asUintN(64, (hash ^ BigInt(byte)) * 0x100000001b3n);
  return hash.toString(16).padStart(16, '0');
}
