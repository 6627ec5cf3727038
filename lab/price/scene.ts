import type { CaseBody, CaseScene, Vec3 } from '../case.js';

/** A scene whose price is measured: a function of its size. */
export interface PriceScene {
  id: string;
  /** Fits over a panel of the picture. */
  name: string;
  size: number;
  /** Of the same kind, cheap enough for tests. */
  small: number;
  /** What its picture shows: how deep bodies overlap, or how far joints gape. */
  judged: 'overlap' | 'gap';
  /** What puts work in; without it energy has to come from nowhere. */
  driven?: string;
  /** The finest level that is measured, where finer ones take minutes. */
  finest?: string;
  /** What `standard` may cost, to Ammo's step: 2.5 by default. */
  bound?: number;
  build(size: number): CaseScene;
}

export const GRAVITY: Vec3 = [0, -9.8, 0];
const CONTACT = { bounce: 0, friction: 0.5 };

export const box = (...size: Vec3) => ({ type: 'Box' as const, size });
export const ball = (radius: number) => ({ type: 'Sphere' as const, radius });

/** What touches and falls. */
export const touching = (
  bodies: CaseBody[],
  joints: NonNullable<CaseScene['joints']> = [],
): CaseScene => ({ gravity: GRAVITY, bodies, joints, contact: CONTACT });

/** A slab whose top lies at 0. */
export const floor = (width: number): CaseBody => ({
  name: 'floor',
  fixed: true,
  position: [0, -0.5, 0],
  shape: box(width, 1, width),
});

/** From 0 to 1, the same sequence in every run. */
export function random(): () => number {
  let state = 1;
  return () => (state = (state * 16807) % 2147483647) / 2147483647;
}

/** Places in layers of `row` × `row`, so far apart, from a height on. */
export function layers(count: number, row: number, apart: number, from: number): Vec3[] {
  const middle = (row - 1) / 2;
  return Array.from({ length: count }, (_, i) => [
    apart * ((i % row) - middle),
    from + apart * Math.floor(i / row ** 2),
    apart * ((Math.floor(i / row) % row) - middle),
  ]);
}
