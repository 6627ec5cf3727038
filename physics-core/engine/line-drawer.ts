import type { Ammo } from './ammo.js';
import type { Owner } from './owner.js';

export type LineDrawer = Ammo['DebugDrawer']['prototype'];

/** Hands on the lines of Bullet's debug drawing: both ends, and how red they are. The ends are to be copied at once. */
export function makeLineDrawer(
  ammo: Ammo,
  owner: Owner,
  draw: (from: Float32Array, to: Float32Array, red: number) => void,
): LineDrawer {
  const drawer = owner.own(new ammo.DebugDrawer());
  // Bullet hands over pointers to vectors.
  drawer.drawLine = (from: number, to: number, color: number) => {
    const heap = ammo.HEAPF32;
    const a = from >> 2;
    const b = to >> 2;
    draw(heap.subarray(a, a + 3), heap.subarray(b, b + 3), heap[color >> 2]!);
  };
  drawer.getDebugMode = () => 0;
  const nothing = (): void => {};
  return Object.assign(drawer, {
    drawContactPoint: nothing,
    reportErrorWarning: nothing,
    draw3dText: nothing,
    setDebugMode: nothing,
  });
}
