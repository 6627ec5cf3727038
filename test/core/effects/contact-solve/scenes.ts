import { eachContactPoint } from '../../../../physics-core/effects/contacts/contact-points.js';
import { MANIFOLD_POINT } from '../../../../physics-core/engine/offsets.js';
import type { World } from '../../../../physics-core/inside.js';
import { addBody, addFloor, distance, position, world, type Body } from '../../helpers.js';

export { arch, cards, hullCube, pyramid, stack, wall } from '../../../../references/structures.js';

// What stands, and how far it moved from where it was put.

export type Fields = Record<string, unknown>;

/** m/s², of a world that says nothing else. */
export const G = 9.8;

export interface Standing {
  w: World;
  floor: Body;
  bodies: Body[];
  /** How far the one that moved most is from where it was put, metres. */
  moved(): number;
}

/** Puts them on a floor. */
export async function standing(all: Fields[], fields: Fields = {}): Promise<Standing> {
  const w = await world(fields);
  const floor = addFloor(w);
  const bodies = all.map((one) => addBody(w, one));
  const before = all.map((one) => one.position as number[]);
  const moved = () => Math.max(...bodies.map((body, i) => distance(position(body), before[i]!)));
  return { w, floor, bodies, moved };
}

/** The farthest that any of them was from its place, looked at ten times a second, metres. */
export function farthest({ w, moved }: Standing, seconds: number): number {
  let most = 0;
  for (let i = 0; i < 10 * seconds; i++) {
    w.advance(0.1);
    most = Math.max(most, moved());
  }
  return most;
}

/** What points of contact push a body with, N; those with one other body, where it is named. */
export function borne(w: World, body: Body, by?: Body): number {
  const f = w.engine.ammo.HEAPF32;
  let sum = 0;
  eachContactPoint(w, (pointer, a, b) => {
    const pair = [a, b] as unknown[];
    if (!pair.includes(body) || (by && !pair.includes(by))) return;
    sum += f[(pointer + MANIFOLD_POINT.impulse) >> 2]!;
  });
  return sum / w.timeStep;
}
