import type { Vec3 } from '../../fields/types.js';
import type { Material } from './material.js';
import { AIR } from '../tolerances.js';

/**
 * Air that goes by `wind`, m/s, pushes each triangle along its normal: half of its density times the square of how fast it
 * comes there, on the area. In a part of a step no more than makes a corner go as the air does.
 */
export function blow({ masses, surface }: Material, wind: Vec3, time: number): void {
  const { places, velocities, inverse } = masses;
  const { triangles, carriers } = surface;
  for (let n = 0; n + 2 < triangles.length; n += 3) {
    const i = carriers[triangles[n]!]!;
    const j = carriers[triangles[n + 1]!]!;
    const m = carriers[triangles[n + 2]!]!;
    const a = 3 * i;
    const b = 3 * j;
    const c = 3 * m;
    const ux = places[b]! - places[a]!;
    const uy = places[b + 1]! - places[a + 1]!;
    const uz = places[b + 2]! - places[a + 2]!;
    const vx = places[c]! - places[a]!;
    const vy = places[c + 1]! - places[a + 1]!;
    const vz = places[c + 2]! - places[a + 2]!;
    const x = uy * vz - uz * vy;
    const y = uz * vx - ux * vz;
    const z = ux * vy - uy * vx;
    const size = Math.sqrt(x * x + y * y + z * z);
    if (!(size > 0)) continue;
    const speed =
      (x * (wind[0] - (velocities[a]! + velocities[b]! + velocities[c]!) / 3) +
        y * (wind[1] - (velocities[a + 1]! + velocities[b + 1]! + velocities[c + 1]!) / 3) +
        z * (wind[2] - (velocities[a + 2]! + velocities[b + 2]! + velocities[c + 2]!) / 3)) /
      size;
    // To each corner a third of the half of the product that is the area.
    const push = (time * AIR * Math.abs(speed) * size) / 12;
    const light = Math.max(inverse[i]!, inverse[j]!, inverse[m]!);
    const share = (push * speed) / (1 + push * light) / size;
    add(velocities, a, share * inverse[i]!, x, y, z);
    add(velocities, b, share * inverse[j]!, x, y, z);
    add(velocities, c, share * inverse[m]!, x, y, z);
  }
}

function add(to: Float64Array, at: number, share: number, x: number, y: number, z: number): void {
  to[at]! += share * x;
  to[at + 1]! += share * y;
  to[at + 2]! += share * z;
}
