import { METS, MET, type Obstacles } from './collide/obstacles.js';
import type { SheetSolid } from './collide/sheet.js';
import { FOUND, WAY } from './collide/solid.js';
import type { Moving } from './moving.js';
import type { Surface } from './surface.js';

const way = new Float64Array(WAY);
const found = new Float64Array(FOUND);

/** What a particle meets on its way. */
export class Meeting {
  readonly met = new Float64Array(METS);
  /** It is a wall, and no body. */
  isWall = false;
  readonly #obstacles: Obstacles;

  constructor(obstacles: Obstacles) {
    this.#obstacles = obstacles;
  }

  /** Whether something is in its way from the share `start` of the step on. */
  meets({ from, to }: Moving, { bodies, walls, radius }: Surface, start: number): boolean {
    const met = this.met;
    const isBody = bodies && this.#obstacles.meet(from, to, radius, met, start, 1);
    if (walls) {
      way[6] = radius;
      way[7] = isBody ? met[MET.share]! : 1;
      this.isWall = meetsWall(walls, from, to, start, met);
    } else this.isWall = false;
    const isMet = isBody || this.isWall;
    if (isMet) makeUnit(met);
    return isMet;
  }
}

/** The same for walls; `way` has how wide the particle is, and before which share it is to meet them. */
function meetsWall(
  walls: SheetSolid,
  from: Float64Array,
  to: Float64Array,
  start: number,
  met: Float64Array,
): boolean {
  for (let i = 0; i < 3; i++) {
    way[i] = from[i]!;
    way[3 + i] = to[i]! - from[i]!;
  }
  if (!walls.meets(way, found)) return false;
  const share = found[0]!;
  const depth = found[1]!;
  met[MET.time] = start + (1 - start) * share;
  for (let i = 0; i < 3; i++) {
    const normal = found[2 + i]!;
    met[MET.normal + i] = normal;
    met[MET.place + i] = from[i]! + way[3 + i]! * share + normal * depth;
  }
  return true;
}

/** Poses that were read in single precision turn by a matrix that is a ten-millionth off: what lies would be met again. */
function makeUnit(met: Float64Array): void {
  let square = 0;
  for (let i = MET.normal; i < MET.normal + 3; i++) square += met[i]! ** 2;
  const length = Math.sqrt(square);
  for (let i = MET.normal; i < MET.normal + 3; i++) met[i] = met[i]! / length;
}
