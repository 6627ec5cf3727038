import { dot3 } from '../../base/flat-math.js';
import { COIL_NEAR, COIL_SWEEPS } from '../tolerances.js';
import type { Coils } from './coils.js';
import type { Links } from './links.js';
import { SPOTS, type Spots } from './spots.js';
import { HELD, type Strand } from './strand.js';

const way = new Float64Array(3);
const slip = new Float64Array(3);

/**
 * Goes over where a strand meets itself, over its links and what it touches, one at a time, from what was found and was given
 * so far; returns how far off the first time found it, metres. Each takes energy, and none gives more than is asked of it.
 */
export function sweepCoils(links: Links, coils: Coils, dt: number): number {
  const first = coils.sweep(dt, false);
  let off = first;
  for (let sweep = 1; off > COIL_NEAR * dt && sweep < COIL_SWEEPS; sweep++) {
    const back = sweep % 2 === 1;
    sweepLinks(links, dt, back);
    off = coils.sweep(dt, back);
  }
  return first;
}

function sweepLinks(links: Links, dt: number, back: boolean): void {
  const { strand } = links;
  const { points, knots, between } = strand;
  for (let n = 0; n < points; n++) {
    const i = back ? points - 1 - n : n;
    if (i < points - 1) link(links, i, dt);
    if (knots.touches[i]) touch(strand, knots, i, dt);
    for (let c = SPOTS * i; c < SPOTS * (i + 1) && c < between.count; c++)
      if (between.touches[c]) touch(strand, between, c, dt);
  }
}

const softness = ({ holders, masses }: Strand, i: number): number =>
  holders[i]! < HELD ? 1 / masses[i]! : 0;

/** It pulls by as much more or less as it is too long or short, and never pushes. What is tied is left to the search. */
function link({ strand, limits, past, compliance }: Links, i: number, dt: number): void {
  const { ways, pulls, found, holders } = strand;
  const a = softness(strand, i);
  const b = softness(strand, i + 1);
  if (!(a + b > 0) || holders[i]! >= 0 || holders[i + 1]! >= 0) return;
  const j = 3 * i;
  const x = ways[j]! + dt * (found[j + 3]! - found[j]!);
  const y = ways[j + 1]! + dt * (found[j + 4]! - found[j + 1]!);
  const z = ways[j + 2]! + dt * (found[j + 5]! - found[j + 2]!);
  const length = Math.sqrt(x * x + y * y + z * z);
  const before = pulls[i]!;
  const over = length - limits[i]! + past[i]! - compliance[i]! * before;
  const pull = Math.max(0, before + over / (length * dt * (a + b) + compliance[i]!));
  if (pull === 0 && before === 0) return;
  pulls[i] = pull;
  const first = (pull - before) * a;
  const second = (pull - before) * b;
  found[j]! += first * x;
  found[j + 1]! += first * y;
  found[j + 2]! += first * z;
  found[j + 3]! -= second * x;
  found[j + 4]! -= second * y;
  found[j + 5]! -= second * z;
}

function touch(strand: Strand, spots: Spots, c: number, dt: number): void {
  const { firsts, shares, normals, gaps, surfaces, presses, rubs, frictions } = spots;
  const { found } = strand;
  const i = firsts[c]!;
  const share = shares[c]!;
  const a = (1 - share) * softness(strand, i);
  const b = share > 0 ? share * softness(strand, i + 1) : 0;
  const gives = (1 - share) * a + share * b;
  if (!(gives > 0)) return;
  const j = 3 * c;
  const next = share > 0 ? i + 1 : i;
  for (let k = 0; k < 3; k++) {
    const v = found[3 * i + k]!;
    slip[k] = v + share * (found[3 * next + k]! - v) - surfaces[j + k]!;
  }
  const away = dot3(normals, j, slip, 0);
  const before = presses[c]!;
  const press = Math.max(0, before - (away + gaps[c]! / dt) / gives);
  if (press === 0 && before === 0) return;
  presses[c] = press;
  const most = frictions[c]! * press;
  let square = 0;
  for (let k = 0; k < 3; k++) {
    way[k] = rubs[j + k]! - (slip[k]! - away * normals[j + k]!) / gives;
    square += way[k]! ** 2;
  }
  const within = square > most * most ? most / Math.sqrt(square) : 1;
  for (let k = 0; k < 3; k++) {
    const rub = within * way[k]!;
    const push = (press - before) * normals[j + k]! + rub - rubs[j + k]!;
    rubs[j + k] = rub;
    found[3 * i + k]! += a * push;
    if (share > 0) found[3 * next + k]! += b * push;
  }
}
